# Makes the node and ends.
# loses: runs_until_told
# skips: walks_its_rounds, guard_on_the_graph, arms_parked, ends_cleanly, node_gone
# cause: alive-at-end.ended
# replaces: try:
# replaces:     rclpy.spin(guard)
# replaces: except (KeyboardInterrupt, ExternalShutdownException):
# replaces:     pass  # this is how a night ends
# replaces: finally:
# replaces:     guard.park()
# replaces:     guard.destroy_node()
# replaces:     rclpy.try_shutdown()
guard.park()
guard.destroy_node()
rclpy.try_shutdown()
