# Compares only what points forward with what points up.
# loses: fall_reported
# cause: fall-reported.never
# replaces: return math.degrees(math.atan2(math.hypot(up.x, up.y), up.z))
return math.degrees(math.atan2(abs(up.x), up.z))
