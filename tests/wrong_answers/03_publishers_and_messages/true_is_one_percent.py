# loses: look_alikes_refused
# says: publish_level(True), a bool, came back without an error, and 1.0 went out
"""Forgets that a bool is an int."""

import math
from numbers import Real

from rclpy.node import Node
from std_msgs.msg import Float32


class BatteryPublisher(Node):
    def __init__(self) -> None:
        super().__init__("battery_publisher")
        self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)

    def publish_level(self, level) -> None:
        if not isinstance(level, Real):
            raise TypeError(f"no number: {level!r}")
        if not math.isfinite(level):
            raise ValueError("not finite")
        self.battery_publisher.publish(Float32(data=float(level)))
