# loses: no_number_refused, look_alikes_refused, not_finite_refused, no_invented_zero
# says: publish_level(None) raised TypeError: not a number: None, and 0.0 went out
# says: The error comes too late
"""Looks at the value when it has gone out."""

import math
from numbers import Real

from rclpy.node import Node
from std_msgs.msg import Float32


class BatteryPublisher(Node):
    def __init__(self) -> None:
        super().__init__("battery_publisher")
        self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)

    def publish_level(self, level) -> None:
        charge = float(level) if isinstance(level, Real) else level
        self.battery_publisher.publish(Float32(data=charge))
        if isinstance(level, bool) or not isinstance(level, Real):
            raise TypeError(f"not a number: {level!r}")
        if not math.isfinite(level):
            raise ValueError("not finite")
