# Compares with the bools instead of asking for their type.
# loses: floats_arrive, zero_arrives, numbers_arrive
# cause: number.taken-for-bool
# says: publish_level(1.0)
# replaces: if isinstance(level, bool) or not isinstance(level, Real):
if level in (True, False) or not isinstance(level, Real):
