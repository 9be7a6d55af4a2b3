# The joints are published once, in the constructor, before anybody listens.
# loses: twelve_values, finite_in_range, joints_move, joint_rate
# cause: no-message.silent-beside-others
# after: super().__init__("humanoid_status_publisher")
self.joint_publisher = self.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)
self.publish_joint_positions()

# replaces: self.joint_publisher = self.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)

# replaces: self.joint_timer = self.create_timer(JOINT_PERIOD_S, self.publish_joint_positions)
