# The method is called instead of handed over.
# loses: twelve_values, finite_in_range, joints_move, joint_rate, status_kept, battery_kept, alive_at_end
# cause: error.callback-called
# replaces: self.joint_timer = self.create_timer(JOINT_PERIOD_S, self.publish_joint_positions)
self.joint_timer = self.create_timer(JOINT_PERIOD_S, self.publish_joint_positions())
