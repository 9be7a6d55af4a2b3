# Computes the elevation from the row alone, which is only right in the middle column.
# loses: direction_right, bgr_right
# skips: light_changes, padding_right
# cause: direction.elevation
# replaces: length = math.sqrt(x * x + y * y + 1.0)
yaw, pitch = math.atan(x), math.atan(y)
# replaces: return [x / length, y / length, 1.0 / length]
return [math.sin(yaw) * math.cos(pitch), math.sin(pitch), math.cos(yaw) * math.cos(pitch)]
