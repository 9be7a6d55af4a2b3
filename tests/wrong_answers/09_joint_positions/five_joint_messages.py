# The joint positions are published five times.
# loses: joint_rate
# cause: silence.of-one
# says: the last of 5 messages
# after: self.battery_level = 100.0
self.left = 5

# replaces: self.joint_publisher.publish(message)
if self.left > 0:
    self.joint_publisher.publish(message)
self.left -= 1
