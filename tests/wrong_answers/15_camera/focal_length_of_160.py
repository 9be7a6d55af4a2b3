# Takes the width of the picture for the focal length: near the middle that hardly shows.
# loses: direction_right, bgr_right
# skips: light_changes, padding_right
# cause: direction.focal-length
# replaces: FOCAL = 140.0  # pixels
FOCAL = 160.0
