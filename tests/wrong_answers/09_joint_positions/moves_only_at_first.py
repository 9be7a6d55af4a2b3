# The joints stop after three poses.
# loses: joints_move
# cause: varies.stands-still
# after: self.battery_level = 100.0
self.step = 0

# replaces: message = Float32MultiArray(data=self.joint_angles())
self.step = min(self.step + 1, 3)
message = Float32MultiArray(data=[0.1 * self.step] * JOINT_COUNT)
