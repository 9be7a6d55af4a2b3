# The list is filled after it was published for the first time.
# loses: twelve_values
# cause: length.not-filled
# says: 0
# after: self.battery_level = 100.0
self.angles: list[float] = []

# replaces: message = Float32MultiArray(data=self.joint_angles())
message = Float32MultiArray(data=self.angles)
self.angles = self.joint_angles()
