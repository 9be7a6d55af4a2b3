# The timer of the joints is canceled after twenty seconds of robot time.
# loses: joint_rate
# cause: silence.of-one
# says: the last of 10 messages
# after: self.battery_level = 100.0
self.step = 0

# after: self.joint_publisher.publish(message)
self.step += 1
if self.step == 10:
    self.joint_timer.cancel()
