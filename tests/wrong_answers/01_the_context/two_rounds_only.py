# Ends by itself after two rounds.
# loses: runs_until_told
# skips: walks_its_rounds, guard_on_the_graph, arms_parked, ends_cleanly, node_gone
# cause: alive-at-end.ended
# replaces: ROUND_S = 0.5
ROUND_S = 0.2

# replaces: try:
# replaces:     rclpy.spin(guard)
# replaces: except (KeyboardInterrupt, ExternalShutdownException):
# replaces:     pass  # this is how a night ends
# replaces: finally:
# replaces:     guard.park()
# replaces:     guard.destroy_node()
# replaces:     rclpy.try_shutdown()
while guard.rounds < 2:
    rclpy.spin_once(guard)
guard.park()
guard.destroy_node()
rclpy.shutdown()
