# The angles as JSON in a String.
# loses: joint_topic
# skips: twelve_values, finite_in_range, joints_move, joint_rate
# cause: publishes.other-type
# says: String
# before: import math
import json

# replaces: self.joint_publisher = self.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)
self.joint_publisher = self.create_publisher(String, "/robot/joint_positions", 10)

# replaces: message = Float32MultiArray(data=self.joint_angles())
# replaces: self.joint_publisher.publish(message)
# replaces: self.get_logger().info(f"Joints: {', '.join(f'{angle:.2f}' for angle in message.data)} rad")
self.joint_publisher.publish(String(data=json.dumps(self.joint_angles())))
