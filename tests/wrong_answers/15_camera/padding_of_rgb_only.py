# Cuts off the padding of rgb8 pictures, and forgets that bgr8 pictures have some, too.
# loses: padding_right
# cause: direction.padding-taken-for-pixels
# replaces: pixels = rows[:, : 3 * image.width].reshape(image.height, image.width, 3)
pixels = rows[:, : 3 * image.width].reshape(image.height, image.width, 3)
if image.encoding == "bgr8":
    pixels = rows.reshape(-1)[: 3 * image.height * image.width].reshape(image.height, image.width, 3)
