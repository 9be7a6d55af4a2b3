# Refuses whole numbers.
# loses: numbers_arrive
# cause: numbers-arrive.refused
# replaces: if not isinstance(level, (int, float)):
if not isinstance(level, float):
