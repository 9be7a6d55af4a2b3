# Cuts off the padding of rgb8, and takes the bytes of bgr8 as if no row had padding.
# loses: padding_right
# cause: direction.padding-of-one-encoding
# replaces: rows = np.frombuffer(image.data, np.uint8).reshape(image.height, image.step)
rows = np.frombuffer(image.data, np.uint8).reshape(image.height, image.step)
if image.encoding == "bgr8":
    rows = rows.reshape(-1)[: 3 * image.height * image.width].reshape(image.height, -1)
