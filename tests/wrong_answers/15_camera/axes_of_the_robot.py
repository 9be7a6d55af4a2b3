# Publishes x forward, y to the left, z up.
# loses: direction_right, bgr_right
# skips: light_changes, padding_right
# cause: direction.axes-of-the-robot
# replaces: return [x / length, y / length, 1.0 / length]
return [1.0 / length, -x / length, -y / length]
