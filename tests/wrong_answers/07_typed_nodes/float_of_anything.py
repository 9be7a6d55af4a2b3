# float() reads texts too.
# loses: refuses_wrong_types
# cause: refuses-wrong-types.text-read
# says: send_battery('87.5')
# replaces: if not isinstance(level, (int, float)):
# replaces:     raise TypeError(f"a charge is a number of percent, not {level!r}")
