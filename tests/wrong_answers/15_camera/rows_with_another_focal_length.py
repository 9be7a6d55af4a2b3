# Takes three quarters of the focal length for the rows, as if pixels were not square.
# loses: direction_right, bgr_right
# skips: light_changes, padding_right
# cause: direction.one-axis
# replaces: x, y = (column - CENTER[0]) / FOCAL, (row - CENTER[1]) / FOCAL
x, y = (column - CENTER[0]) / FOCAL, (row - CENTER[1]) / (0.75 * FOCAL)
