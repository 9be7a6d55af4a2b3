# Takes the bytes as if no row had padding.
# loses: padding_right
# cause: direction.padding-taken-for-pixels
# replaces: rows = np.frombuffer(image.data, np.uint8).reshape(image.height, image.step)
rows = np.frombuffer(image.data, np.uint8)[: 3 * image.height * image.width].reshape(image.height, -1)
