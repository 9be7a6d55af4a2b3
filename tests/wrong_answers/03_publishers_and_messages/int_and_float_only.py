# Refuses what comes from NumPy.
# loses: numbers_arrive
# cause: number.refused
# says: publish_level(np.
# replaces: if isinstance(level, bool) or not isinstance(level, Real):
if isinstance(level, bool) or not isinstance(level, (int, float)):
