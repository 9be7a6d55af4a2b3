# Only the head turns.
# loses: joints_move
# cause: varies.too-few
# says: joint 0
# replaces: message = Float32MultiArray(data=self.joint_angles())
message = Float32MultiArray(data=[self.joint_angles()[0]] + [0.2] * 11)
