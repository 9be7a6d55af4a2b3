# Cleans up, but does not park.
# loses: arms_parked
# cause: arms-parked.never
# replaces: guard.park()
