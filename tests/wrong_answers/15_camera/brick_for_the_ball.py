# Takes the biggest orange thing, whatever its outline.
# loses: direction_right, bgr_right, no_ball_said
# skips: light_changes, padding_right
# cause: direction.brick
# replaces: if sums["m00"] >= SMALLEST and sums["m00"] >= ROUND * np.pi * (radius + 0.5) ** 2:
if sums["m00"] >= SMALLEST:
