# loses: floats_arrive
# skips: zero_arrives, numbers_arrive, no_number_refused, look_alikes_refused, not_finite_refused, no_invented_zero
# says: publish_level(87.25) came back without an error, and nothing went out
# says: nobody is connected to it yet
"""Makes the publisher when the first level comes: nobody is connected at that moment."""

import math
from numbers import Real

from rclpy.node import Node
from std_msgs.msg import Float32


class BatteryPublisher(Node):
    def __init__(self) -> None:
        super().__init__("battery_publisher")
        self.battery_publisher = None

    def publish_level(self, level) -> None:
        if isinstance(level, bool) or not isinstance(level, Real):
            raise TypeError(f"no number: {level!r}")
        if not math.isfinite(level):
            raise ValueError("not finite")
        if self.battery_publisher is None:
            self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)
        self.battery_publisher.publish(Float32(data=float(level)))
