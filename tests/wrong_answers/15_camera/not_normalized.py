# Leaves the vector as long as it comes.
# loses: direction_right, light_changes, bgr_right, padding_right
# skips: light_changes, padding_right
# cause: direction-right.not-of-length-one
# replaces: return [x / length, y / length, 1.0 / length]
return [2 * x, 2 * y, 2.0]
