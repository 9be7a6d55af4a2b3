# A context manager, as newer versions of ROS have it.
# loses: program_runs
# skips: joint_topic, twelve_values, finite_in_range, joints_move, joint_rate, status_kept, battery_kept, alive_at_end
# cause: error.context-manager
# replaces: rclpy.init(args=args)
# replaces: try:
# replaces:     rclpy.spin(HumanoidStatusPublisher())
# replaces: except (KeyboardInterrupt, ExternalShutdownException):
# replaces:     pass
# replaces: finally:
# replaces:     rclpy.try_shutdown()
with rclpy.init(args=args):
    rclpy.spin(HumanoidStatusPublisher())
