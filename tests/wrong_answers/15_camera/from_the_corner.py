# Counts pixels from the corner.
# loses: direction_right, bgr_right
# skips: light_changes, padding_right
# cause: direction.from-the-corner
# replaces: x, y = (column - CENTER[0]) / FOCAL, (row - CENTER[1]) / FOCAL
x, y = column / FOCAL, row / FOCAL
