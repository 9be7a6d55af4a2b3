# Refuses what comes from NumPy.
# loses: numbers_arrive
# cause: number.refused
# says: publish_level(np.float32(12.5))
# replaces: if isinstance(level, bool) or not isinstance(level, Real):
if isinstance(level, bool) or not isinstance(level, (int, float)):
