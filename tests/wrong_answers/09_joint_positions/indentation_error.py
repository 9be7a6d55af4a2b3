# A line sits one space too far to the right.
# loses: program_runs
# skips: joint_topic, twelve_values, finite_in_range, joints_move, joint_rate, status_kept, battery_kept, alive_at_end
# cause: error.indentation
# compiles: no
# replaces: message = Float32MultiArray(data=self.joint_angles())
 message = Float32MultiArray(data=self.joint_angles())
