# Publisher is generic in newer versions of rclpy only.
# loses: clean, wrong_message_found
# cause: mypy.generic-publisher
# after: from rclpy.node import Node
from rclpy.publisher import Publisher

# replaces: self.battery_publisher = make_publisher(self, Float32, "/robot/battery")
# replaces: self.status_publisher = make_publisher(self, String, "/robot/status")
self.battery_publisher: Publisher[Float32] = self.create_publisher(Float32, "/robot/battery", 10)
self.status_publisher: Publisher[String] = self.create_publisher(String, "/robot/status", 10)
