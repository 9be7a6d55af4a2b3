# The timer is canceled after two messages.
# loses: joint_rate
# cause: silence.of-one
# says: the last of 2 messages
# after: self.battery_level = 100.0
self.step = 0

# after: self.joint_publisher.publish(message)
self.step += 1
if self.step == 2:
    self.joint_timer.cancel()
