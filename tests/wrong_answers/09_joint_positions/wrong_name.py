# Another topic name than the one asked for.
# loses: joint_topic
# skips: twelve_values, finite_in_range, joints_move, joint_rate
# cause: publishes.other-name
# says: your node publishes on /robot/joint_angles, not on /robot/joint_positions
# replaces: self.joint_publisher = self.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)
self.joint_publisher = self.create_publisher(Float32MultiArray, "/robot/joint_angles", 10)
