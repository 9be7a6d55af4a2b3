# Nothing spins: the program ends with its last line.
# loses: program_runs
# cause: program-runs.ended
# replaces: rclpy.spin(VitalSigns())
VitalSigns()
