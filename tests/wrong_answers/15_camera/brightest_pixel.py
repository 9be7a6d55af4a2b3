# Takes the brightest pixel for the ball.
# loses: direction_right, bgr_right, no_ball_said
# skips: light_changes, padding_right
# cause: direction.beside
# replaces: hsv = cv2.cvtColor(pixels, TO_HSV[image.encoding])
_, _, _, brightest = cv2.minMaxLoc(cv2.cvtColor(pixels, cv2.COLOR_RGB2GRAY))
return brightest
hsv = cv2.cvtColor(pixels, TO_HSV[image.encoding])
