# `with rclpy.init()` is of a newer rclpy.
# loses: program_runs
# skips: runs_until_told, walks_its_rounds, guard_on_the_graph, arms_parked, ends_cleanly, node_gone
# cause: error.context-manager
# replaces: rclpy.init(args=args)
# replaces: guard = NightGuard()
# replaces: try:
# replaces:     rclpy.spin(guard)
# replaces: except (KeyboardInterrupt, ExternalShutdownException):
# replaces:     pass  # this is how a night ends
# replaces: finally:
# replaces:     guard.park()
# replaces:     guard.destroy_node()
# replaces:     rclpy.try_shutdown()
with rclpy.init():
    guard = NightGuard()
    try:
        rclpy.spin(guard)
    except KeyboardInterrupt:
        guard.park()
