# Subtracts a middle that is four columns to the right.
# loses: direction_right, bgr_right
# skips: light_changes, padding_right
# cause: direction.middle
# replaces: CENTER = (79.5, 59.5)  # column and row of a point straight ahead
CENTER = (83.5, 59.5)
