# loses: look_alikes_refused
# says: publish_level('50'), a text, came back without an error, and 50.0 went out
# says: float() reads texts
"""Asks float() whether it is a number."""

import math

from rclpy.node import Node
from std_msgs.msg import Float32


class BatteryPublisher(Node):
    def __init__(self) -> None:
        super().__init__("battery_publisher")
        self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)

    def publish_level(self, level) -> None:
        if isinstance(level, bool):
            raise TypeError("a bool")
        charge = float(level)
        if not math.isfinite(charge):
            raise ValueError("not finite")
        self.battery_publisher.publish(Float32(data=charge))
