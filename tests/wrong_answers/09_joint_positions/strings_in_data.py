# The angles are formatted as text.
# loses: twelve_values, finite_in_range, joints_move, joint_rate, status_kept, battery_kept, alive_at_end
# cause: error.wrong-value-type
# replaces: message = Float32MultiArray(data=self.joint_angles())
message = Float32MultiArray(data=[f"{angle:.3f}" for angle in self.joint_angles()])
