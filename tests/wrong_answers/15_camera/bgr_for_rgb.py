# Reads every picture as BGR, as OpenCV does.
# loses: direction_right, no_ball_said
# skips: light_changes, padding_right
# cause: direction.blue-ball
# replaces: hsv = cv2.cvtColor(pixels, TO_HSV[image.encoding])
hsv = cv2.cvtColor(pixels, cv2.COLOR_BGR2HSV)
