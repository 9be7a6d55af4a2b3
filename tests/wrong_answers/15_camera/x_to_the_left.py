# Lets x point to the left.
# loses: direction_right, bgr_right
# skips: light_changes, padding_right
# cause: direction.x-to-the-left
# replaces: x, y = (column - CENTER[0]) / FOCAL, (row - CENTER[1]) / FOCAL
x, y = (CENTER[0] - column) / FOCAL, (row - CENTER[1]) / FOCAL
