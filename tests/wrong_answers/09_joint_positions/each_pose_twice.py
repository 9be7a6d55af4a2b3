# Every pose is sent twice.
# loses: joints_move
# cause: varies.stands-still
# after: self.battery_level = 100.0
self.step = 0

# replaces: message = Float32MultiArray(data=self.joint_angles())
self.step += 1
message = Float32MultiArray(data=[0.1 * (self.step // 2)] * JOINT_COUNT)
