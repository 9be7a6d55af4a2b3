# Takes 0.0 for a level that is missing.
# loses: numbers_arrive
# cause: numbers-arrive.zero-refused
# replaces: if not isinstance(level, (int, float)):
if not level or not isinstance(level, (int, float)):
