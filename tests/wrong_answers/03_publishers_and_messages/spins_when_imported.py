# loses: calls_come_back
# says: your file runs on and on by itself
# says: if __name__ == '__main__'
"""A whole program at the left margin, so the import of this file never ends."""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32


class BatteryPublisher(Node):
    def __init__(self) -> None:
        super().__init__("battery_publisher")
        self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)

    def publish_level(self, level) -> None:
        self.battery_publisher.publish(Float32(data=float(level)))


rclpy.init()
rclpy.spin(BatteryPublisher())
