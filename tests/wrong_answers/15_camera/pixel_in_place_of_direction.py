# Publishes column and row.
# loses: direction_right, bgr_right
# skips: light_changes, padding_right
# cause: direction.a-pixel
# replaces: return [x / length, y / length, 1.0 / length]
return [column, row, 0.0]
