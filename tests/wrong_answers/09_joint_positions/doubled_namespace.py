# A node in the namespace robot whose relative name says robot again.
# loses: joint_topic
# skips: twelve_values, finite_in_range, joints_move, joint_rate
# cause: publishes.other-namespace
# says: /robot/robot/joint_positions
# replaces: super().__init__("humanoid_status_publisher")
super().__init__("humanoid_status_publisher", namespace="robot")

# replaces: self.joint_publisher = self.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)
self.joint_publisher = self.create_publisher(Float32MultiArray, "robot/joint_positions", 10)
