# Takes the padding for ten more columns, and makes the picture 160 columns wide again.
# loses: padding_right
# cause: direction.squeezed
# replaces: pixels = rows[:, : 3 * image.width].reshape(image.height, image.width, 3)
wide = rows[:, : image.step // 3 * 3].reshape(image.height, -1, 3)
pixels = cv2.resize(wide, (image.width, image.height))
