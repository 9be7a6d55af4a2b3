# The list is an attribute that grows by twelve with each message.
# loses: twelve_values, joints_move
# cause: length.other-list
# after: self.battery_level = 100.0
self.angles: list[float] = []

# replaces: message = Float32MultiArray(data=self.joint_angles())
self.angles += self.joint_angles()
message = Float32MultiArray(data=self.angles)
