# The angles grow by half a radian for ever and are never wrapped.
# loses: finite_in_range
# cause: within.not-wrapped
# says: rad
# after: self.battery_level = 100.0
self.step = 0

# replaces: message = Float32MultiArray(data=self.joint_angles())
self.step += 1
message = Float32MultiArray(data=[0.5 * (self.step + joint) for joint in range(JOINT_COUNT)])
