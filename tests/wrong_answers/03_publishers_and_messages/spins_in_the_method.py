# loses: calls_come_back
# says: publish_level(87.25) never came back
# says: To publish, nothing has to spin
"""Believes that a message goes out only when somebody spins."""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32


class BatteryPublisher(Node):
    def __init__(self) -> None:
        super().__init__("battery_publisher")
        self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)

    def publish_level(self, level) -> None:
        self.battery_publisher.publish(Float32(data=float(level)))
        rclpy.spin(self)
