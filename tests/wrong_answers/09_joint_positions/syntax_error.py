# A bracket is not closed.
# loses: program_runs
# skips: joint_topic, twelve_values, finite_in_range, joints_move, joint_rate, status_kept, battery_kept, alive_at_end
# cause: error.syntax
# compiles: no
# replaces: self.joint_timer = self.create_timer(JOINT_PERIOD_S, self.publish_joint_positions)
self.joint_timer = self.create_timer(JOINT_PERIOD_S, self.publish_joint_positions
