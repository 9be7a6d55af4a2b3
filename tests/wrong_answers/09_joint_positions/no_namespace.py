# The name without its first part.
# loses: joint_topic
# skips: twelve_values, finite_in_range, joints_move, joint_rate
# cause: publishes.no-namespace
# says: /joint_positions
# replaces: self.joint_publisher = self.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)
self.joint_publisher = self.create_publisher(Float32MultiArray, "joint_positions", 10)
