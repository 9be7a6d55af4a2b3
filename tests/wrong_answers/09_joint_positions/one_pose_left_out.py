# Leaves out one message of the joint positions.
# loses: joint_rate
# cause: rate.skips
# after: self.battery_level = 100.0
self.poses = 0

# replaces: self.joint_publisher.publish(message)
self.poses += 1
if self.poses != 5:
    self.joint_publisher.publish(message)
