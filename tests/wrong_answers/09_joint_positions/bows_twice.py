# One pose is sent twice, and one step moves a single joint.
# loses: joints_move
# cause: varies.two-kinds
# after: self.battery_level = 100.0
self.step = 0
home, wave = [0.0] * JOINT_COUNT, [0.0] * 4 + [-1.0, -0.5] + [0.0] * 6
self.poses = [home, wave, [*wave[:5], -1.2, *wave[6:]], [0.4, 0.6] + [0.0] * 10, [0.4, 0.6] + [0.0] * 10]

# replaces: message = Float32MultiArray(data=self.joint_angles())
self.step += 1
message = Float32MultiArray(data=self.poses[self.step % 5])
