# One joint swings a little too far.
# loses: finite_in_range
# cause: within.beyond-pi
# replaces: message = Float32MultiArray(data=self.joint_angles())
message = Float32MultiArray(data=self.joint_angles())
message.data[0] *= 11.0
