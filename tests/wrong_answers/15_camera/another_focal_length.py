# Computes with half of the focal length.
# loses: direction_right, bgr_right
# skips: light_changes, padding_right
# cause: direction.beside
# replaces: FOCAL = 140.0  # pixels
FOCAL = 70.0
