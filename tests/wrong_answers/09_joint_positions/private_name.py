# A private name, which the node's own name is put in front of.
# loses: joint_topic
# skips: twelve_values, finite_in_range, joints_move, joint_rate
# cause: publishes.private-name
# says: /humanoid_status_publisher/joint_positions
# replaces: self.joint_publisher = self.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)
self.joint_publisher = self.create_publisher(Float32MultiArray, "~/joint_positions", 10)
