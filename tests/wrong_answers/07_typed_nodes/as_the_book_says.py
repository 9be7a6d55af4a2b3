# rclpy's own Publisher as the hint: this version of it takes messages of every type.
# loses: wrong_message_found
# cause: wrong-message-found.publisher-takes-any
# says: `robot.battery_publisher.publish
# after: from rclpy.node import Node
from rclpy.publisher import Publisher

# replaces: self.battery_publisher = make_publisher(self, Float32, "/robot/battery")
# replaces: self.status_publisher = make_publisher(self, String, "/robot/status")
self.battery_publisher: Publisher = self.create_publisher(Float32, "/robot/battery", 10)
self.status_publisher: Publisher = self.create_publisher(String, "/robot/status", 10)
