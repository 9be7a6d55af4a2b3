# Cleans up behind spin, where Ctrl-C never gets to.
# loses: arms_parked, ends_cleanly
# cause: arms-parked.never
# replaces: try:
# replaces:     rclpy.spin(guard)
# replaces: except (KeyboardInterrupt, ExternalShutdownException):
# replaces:     pass  # this is how a night ends
# replaces: finally:
# replaces:     guard.park()
# replaces:     guard.destroy_node()
# replaces:     rclpy.try_shutdown()
rclpy.spin(guard)
guard.park()
guard.destroy_node()
rclpy.shutdown()
