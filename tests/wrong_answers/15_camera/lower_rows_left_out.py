# Leaves out the lowest 35 rows, where the hands are.
# loses: direction_right, bgr_right
# skips: light_changes, padding_right
# cause: direction.no-ball
# after: orange = cv2.inRange(hsv, *ORANGE)
orange[85:] = 0
