# Takes the angle for proportional to the column and the row.
# loses: direction_right, bgr_right
# skips: light_changes, padding_right
# cause: direction.another-scale
# replaces: length = math.sqrt(x * x + y * y + 1.0)
# replaces: return [x / length, y / length, 1.0 / length]
pan, tilt = math.radians(59.5 * 140 / 160) * x, math.radians(59.5 * 140 / 160) * y
return [math.sin(pan) * math.cos(tilt), math.sin(tilt), math.cos(pan) * math.cos(tilt)]
