# loses: floats_arrive
# says: Something publishes besides
"""Keeps the level and repeats it by a timer, so that there is more on the wire than was said."""

import math
from numbers import Real

from rclpy.node import Node
from std_msgs.msg import Float32


class BatteryPublisher(Node):
    def __init__(self) -> None:
        super().__init__("battery_publisher")
        self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)

        self.level = 100.0
        self.create_timer(0.02, self.publish)

    def publish(self) -> None:
        self.battery_publisher.publish(Float32(data=self.level))

    def publish_level(self, level) -> None:
        if isinstance(level, bool) or not isinstance(level, Real):
            raise TypeError(f"no number: {level!r}")
        if not math.isfinite(level):
            raise ValueError("not finite")
        self.level = float(level)
        self.publish()
