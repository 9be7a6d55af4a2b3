# A joint at its stop is given as infinite.
# loses: finite_in_range
# cause: finite.not-finite
# says: inf
# replaces: message = Float32MultiArray(data=self.joint_angles())
angles = self.joint_angles()
angles[5] = math.inf
message = Float32MultiArray(data=angles)
