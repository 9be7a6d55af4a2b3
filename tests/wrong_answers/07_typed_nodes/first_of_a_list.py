# Takes the first element of a list.
# loses: refuses_wrong_types
# cause: refuses-wrong-types.value-accepted
# says: send_battery([50.0])
# before: if not isinstance(level, (int, float)):
if isinstance(level, list):
    level = level[0]
