# Takes nothing for a ball that is not at least 16 pixels wide.
# loses: direction_right, bgr_right
# skips: light_changes, padding_right
# cause: direction.too-small
# replaces: SMALLEST = 25  # pixels
SMALLEST = 200
