# Reads every picture as RGB.
# loses: bgr_right, no_ball_said
# cause: direction.blue-ball
# replaces: hsv = cv2.cvtColor(pixels, TO_HSV[image.encoding])
hsv = cv2.cvtColor(pixels, cv2.COLOR_RGB2HSV)
