# Asks for a brightness that the ball has in good light only.
# loses: light_changes, bgr_right, padding_right
# cause: direction.too-dark
# replaces: ORANGE = ((4, 130, 35), (22, 255, 255))  # hue (0 to 179), saturation, value
ORANGE = ((4, 130, 85), (22, 255, 255))
