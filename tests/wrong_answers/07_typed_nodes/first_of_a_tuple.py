# Takes the first element of a tuple.
# loses: refuses_wrong_types
# cause: refuses-wrong-types.value-accepted
# says: send_battery((50.0,))
# before: if not isinstance(level, (int, float)):
if isinstance(level, tuple):
    level = level[0]
