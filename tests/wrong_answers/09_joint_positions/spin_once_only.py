# spin_once in the place of spin: one callback, then the end.
# loses: twelve_values, finite_in_range, joints_move, joint_rate, status_kept, battery_kept, alive_at_end
# cause: silence.program-ended
# replaces: rclpy.spin(HumanoidStatusPublisher())
rclpy.spin_once(HumanoidStatusPublisher())
