# Each message moves one joint, and the next message another one.
# loses: joints_move
# cause: varies.one-at-a-time
# after: self.battery_level = 100.0
self.step = 0
self.angles = [0.0] * JOINT_COUNT

# replaces: message = Float32MultiArray(data=self.joint_angles())
self.angles[self.step % JOINT_COUNT] += 0.1
self.step += 1
message = Float32MultiArray(data=self.angles)
