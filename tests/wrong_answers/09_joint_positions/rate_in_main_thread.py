# A Rate sleeps in the only thread, and nobody spins to wake it.
# loses: twelve_values, finite_in_range, joints_move, joint_rate, status_kept, battery_kept
# cause: spin.rate-without-a-spin
# replaces: self.joint_timer = self.create_timer(JOINT_PERIOD_S, self.publish_joint_positions)

# replaces: rclpy.spin(HumanoidStatusPublisher())
node = HumanoidStatusPublisher()
rate = node.create_rate(0.5)
while rclpy.ok():
    rate.sleep()
    node.publish_joint_positions()
