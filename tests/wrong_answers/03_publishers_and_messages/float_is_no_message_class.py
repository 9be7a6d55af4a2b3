# loses: calls_come_back
# says: type object 'type' has no attribute '_TYPE_SUPPORT'
# says: is no message class
"""Gives create_publisher a Python type."""

from rclpy.node import Node


class BatteryPublisher(Node):
    def __init__(self) -> None:
        super().__init__("battery_publisher")
        self.battery_publisher = self.create_publisher(float, "/robot/battery", 10)

    def publish_level(self, level) -> None:
        self.battery_publisher.publish(float(level))
