# Destroys the node and then needs its name.
# loses: arms_parked, ends_cleanly
# cause: error.destroyed
# replaces: guard.park()
# replaces: guard.destroy_node()
guard.destroy_node()
print(guard.get_name(), "says good night")
guard.park()
