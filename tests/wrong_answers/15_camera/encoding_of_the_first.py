# Remembers the encoding of the first picture.
# loses: bgr_right, no_ball_said
# cause: direction.blue-ball
# after: ROUND = 0.75  # a ball fills at least this share of its enclosing circle
FIRST: list[str] = []
# replaces: hsv = cv2.cvtColor(pixels, TO_HSV[image.encoding])
FIRST.append(image.encoding)
hsv = cv2.cvtColor(pixels, TO_HSV[FIRST[0]])
