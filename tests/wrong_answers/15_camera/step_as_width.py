# Takes the padding for pixels, and scales the picture.
# loses: padding_right
# cause: direction.padding-taken-for-pixels
# replaces: pixels = rows[:, : 3 * image.width].reshape(image.height, image.width, 3)
pixels = np.ascontiguousarray(rows[:, : rows.shape[1] // 3 * 3]).reshape(-1, 3)[: image.height * image.width]
pixels = pixels.reshape(image.height, image.width, 3)
