# Misspells a name in a line that only Ctrl-C reaches.
# loses: arms_parked, ends_cleanly
# cause: error.name-not-defined
# says: gaurd
# replaces: guard.park()
gaurd.park()
