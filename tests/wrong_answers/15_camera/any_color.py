# Takes the biggest round thing of a strong color.
# loses: no_ball_said
# cause: no-ball-said.blue-ball
# replaces: ORANGE = ((4, 130, 35), (22, 255, 255))  # hue (0 to 179), saturation, value
ORANGE = ((0, 130, 35), (180, 255, 255))
