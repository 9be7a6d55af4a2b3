# No rclpy.init().
# loses: program_runs
# skips: joint_topic, twelve_values, finite_in_range, joints_move, joint_rate, status_kept, battery_kept, alive_at_end
# cause: error.not-initialized
# replaces: rclpy.init(args=args)
