# Parks before the night has begun.
# loses: arms_parked
# cause: arms-parked.too-early
# after: guard = NightGuard()
guard.park()

# replaces: guard.park()
# replaces: guard.destroy_node()
guard.destroy_node()
