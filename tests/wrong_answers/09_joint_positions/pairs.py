# Two timers call the same method, so messages come two at a time.
# loses: joint_rate
# cause: rate.in-bursts
# after: self.joint_timer = self.create_timer(JOINT_PERIOD_S, self.publish_joint_positions)
self.second_timer = self.create_timer(JOINT_PERIOD_S, self.publish_joint_positions)
