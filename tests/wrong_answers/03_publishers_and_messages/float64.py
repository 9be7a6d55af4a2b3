# loses: battery_topic
# skips: floats_arrive, zero_arrives, numbers_arrive, no_number_refused, look_alikes_refused, not_finite_refused, no_invented_zero
# says: /robot/battery carries Float64
"""Sends 64 bits where 32 were agreed on."""

import math
from numbers import Real

from rclpy.node import Node
from std_msgs.msg import Float64


class BatteryPublisher(Node):
    def __init__(self) -> None:
        super().__init__("battery_publisher")
        self.battery_publisher = self.create_publisher(Float64, "/robot/battery", 10)

    def publish_level(self, level) -> None:
        if isinstance(level, bool) or not isinstance(level, Real):
            raise TypeError(f"no number: {level!r}")
        if not math.isfinite(level):
            raise ValueError("not finite")
        self.battery_publisher.publish(Float64(data=float(level)))
