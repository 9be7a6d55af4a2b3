# Reshapes by the width alone, which raises where rows have padding.
# loses: keeps_up, refuses_others, padding_right
# cause: error.exception
# replaces: rows = np.frombuffer(image.data, np.uint8).reshape(image.height, image.step)
rows = np.frombuffer(image.data, np.uint8).reshape(image.height, 3 * image.width)
