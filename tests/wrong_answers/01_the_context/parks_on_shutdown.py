# Leaves the parking to a callback that Ctrl-C does not call.
# loses: arms_parked
# cause: arms-parked.never
# after: guard = NightGuard()
rclpy.get_default_context().on_shutdown(guard.park)

# replaces: guard.park()
# replaces: guard.destroy_node()
guard.destroy_node()
