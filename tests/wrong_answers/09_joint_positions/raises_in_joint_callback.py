# The third pose does not exist.
# loses: joint_rate, battery_kept, alive_at_end
# cause: error.exception
# says: IndexError
# after: self.battery_level = 100.0
self.poses = [[0.2] * JOINT_COUNT, [0.3] * JOINT_COUNT]

# replaces: message = Float32MultiArray(data=self.joint_angles())
message = Float32MultiArray(data=self.poses.pop(0))
