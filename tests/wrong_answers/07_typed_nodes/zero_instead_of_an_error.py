# Sends 0.0 in the place of what is no number.
# loses: refuses_wrong_types
# cause: refuses-wrong-types.value-accepted
# replaces: raise TypeError(f"a charge is a number of percent, not {level!r}")
level = 0.0
