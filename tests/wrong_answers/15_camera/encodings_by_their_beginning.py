# Looks at the first letters of the encoding, and reads rgba8 as if it were rgb8.
# loses: refuses_others
# cause: refuses-others.says-no-ball
# replaces: if image.encoding not in TO_HSV:
if image.encoding[:3] not in ("rgb", "bgr"):
# replaces: hsv = cv2.cvtColor(pixels, TO_HSV[image.encoding])
hsv = cv2.cvtColor(pixels, TO_HSV[image.encoding[:3] + "8"])
