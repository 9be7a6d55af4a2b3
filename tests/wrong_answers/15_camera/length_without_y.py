# Leaves y out of the length by which it divides.
# loses: direction_right, bgr_right
# skips: light_changes, padding_right
# cause: direction.not-of-length-one
# replaces: length = math.sqrt(x * x + y * y + 1.0)
length = math.sqrt(x * x + 1.0)
