# loses: zero_arrives, numbers_arrive
# says: publish_level(0.0) raised ValueError: no charge given
# says: Zero counts as false
"""Takes an empty battery for a missing value."""

import math
from numbers import Real

from rclpy.node import Node
from std_msgs.msg import Float32


class BatteryPublisher(Node):
    def __init__(self) -> None:
        super().__init__("battery_publisher")
        self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)

    def publish_level(self, level) -> None:
        if not level:
            raise ValueError("no charge given")
        if isinstance(level, bool) or not isinstance(level, Real):
            raise TypeError(f"no number: {level!r}")
        if not math.isfinite(level):
            raise ValueError("not finite")
        self.battery_publisher.publish(Float32(data=float(level)))
