# Takes the bytes as if no row had padding.
# loses: padding_right
# cause: direction.no-ball
# replaces: rows = np.frombuffer(image.data, np.uint8).reshape(image.height, image.step)
rows = np.frombuffer(image.data, np.uint8)[: 3 * image.height * image.width].reshape(image.height, -1)
