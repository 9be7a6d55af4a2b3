# An attribute of Node is overwritten.
# loses: program_runs
# skips: joint_topic, twelve_values, finite_in_range, joints_move, joint_rate, status_kept, battery_kept, alive_at_end
# cause: error.name-taken
# replaces: self.joint_publisher = self.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)
self.publishers = self.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)

# replaces: self.joint_publisher.publish(message)
self.publishers.publish(message)
