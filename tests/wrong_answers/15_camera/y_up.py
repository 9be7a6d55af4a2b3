# Lets y point up.
# loses: direction_right, bgr_right
# skips: light_changes, padding_right
# cause: direction.y-up
# replaces: x, y = (column - CENTER[0]) / FOCAL, (row - CENTER[1]) / FOCAL
x, y = (column - CENTER[0]) / FOCAL, (CENTER[1] - row) / FOCAL
