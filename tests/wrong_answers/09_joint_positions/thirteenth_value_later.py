# From the tenth message on, there is a value for the gripper, too.
# loses: twelve_values
# cause: length.changes
# after: self.battery_level = 100.0
self.poses = 0

# before: self.joint_publisher.publish(message)
self.poses += 1
if self.poses >= 10:
    message.data.append(0.1)
