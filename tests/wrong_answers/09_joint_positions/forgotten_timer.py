# Publisher and callback are there, the timer is not.
# loses: twelve_values, finite_in_range, joints_move, joint_rate
# cause: no-message.silent-beside-others
# replaces: self.joint_timer = self.create_timer(JOINT_PERIOD_S, self.publish_joint_positions)
