# Takes None for an empty battery.
# loses: refuses_wrong_types
# cause: refuses-wrong-types.none-becomes-zero
# says: send_battery(None)
# before: if not isinstance(level, (int, float)):
if level in (None,):
    level = 0.0
