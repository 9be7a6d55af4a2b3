# Leaves the vector as long as it comes.
# loses: direction_right, bgr_right
# skips: light_changes, padding_right
# cause: direction.not-of-length-one
# replaces: return [x / length, y / length, 1.0 / length]
return [2 * x, 2 * y, 2.0]
