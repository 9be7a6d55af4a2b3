# loses: look_alikes_refused, not_finite_refused
# says: publish_level(True), a bool, came back without an error, and 1.0 went out
# says: a bool is a kind of int
"""Converts, and lets float() do the refusing."""

from rclpy.node import Node
from std_msgs.msg import Float32


class BatteryPublisher(Node):
    def __init__(self) -> None:
        super().__init__("battery_publisher")
        self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)

    def publish_level(self, level) -> None:
        self.battery_publisher.publish(Float32(data=float(level)))
