# Nothing spins, so main is over at once.
# loses: program_runs
# skips: joint_topic, twelve_values, finite_in_range, joints_move, joint_rate, status_kept, battery_kept, alive_at_end
# cause: program-runs.ended
# replaces: rclpy.spin(HumanoidStatusPublisher())
HumanoidStatusPublisher()
