# Takes what is bright for the ball, whatever its color.
# loses: direction_right, bgr_right, no_ball_said
# skips: light_changes, padding_right
# cause: direction.no-ball
# replaces: orange = cv2.inRange(hsv, *ORANGE)
orange = cv2.inRange(hsv, (0, 0, 150), (180, 255, 255))
