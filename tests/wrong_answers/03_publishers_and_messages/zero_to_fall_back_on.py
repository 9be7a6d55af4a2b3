# loses: no_number_refused, look_alikes_refused, not_finite_refused, no_invented_zero
# cause: refusal.no-number-sent
# says: published: 0.0
"""Sends 0.0 where it cannot read the value."""

import math

from rclpy.node import Node
from std_msgs.msg import Float32


class BatteryPublisher(Node):
    def __init__(self) -> None:
        super().__init__("battery_publisher")
        self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)

    def publish_level(self, level) -> None:
        try:
            charge = float(level)
        except (TypeError, ValueError):
            charge = 0.0
        if not math.isfinite(charge):
            charge = 0.0
        self.battery_publisher.publish(Float32(data=charge))
