# One joint of the third message is not a number.
# loses: finite_in_range
# cause: finite.not-finite
# says: nan
# after: self.battery_level = 100.0
self.step = 0

# replaces: message = Float32MultiArray(data=self.joint_angles())
self.step += 1
angles = self.joint_angles()
if self.step == 3:
    angles[7] = float("nan")
message = Float32MultiArray(data=angles)
