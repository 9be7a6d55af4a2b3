# Twelve single numbers instead of an array of twelve.
# loses: joint_topic
# skips: twelve_values, finite_in_range, joints_move, joint_rate
# cause: publishes.other-type
# says: Float32
# replaces: self.joint_publisher = self.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)
self.joint_publisher = self.create_publisher(Float32, "/robot/joint_positions", 10)

# replaces: message = Float32MultiArray(data=self.joint_angles())
# replaces: self.joint_publisher.publish(message)
# replaces: self.get_logger().info(f"Joints: {', '.join(f'{angle:.2f}' for angle in message.data)} rad")
for angle in self.joint_angles():
    self.joint_publisher.publish(Float32(data=angle))
