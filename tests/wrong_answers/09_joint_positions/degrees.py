# The angles are in degrees.
# loses: finite_in_range
# cause: within.degrees
# replaces: message = Float32MultiArray(data=self.joint_angles())
message = Float32MultiArray(data=[math.degrees(angle) for angle in self.joint_angles()])
