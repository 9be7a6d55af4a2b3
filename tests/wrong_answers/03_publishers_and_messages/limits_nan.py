# loses: not_finite_refused
# says: publish_level(nan) came back without an error, and 100.0 went out
# says: A comparison with nan is always False
"""Limits the value, and so turns nan into a full battery."""

from numbers import Real

from rclpy.node import Node
from std_msgs.msg import Float32


class BatteryPublisher(Node):
    def __init__(self) -> None:
        super().__init__("battery_publisher")
        self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)

    def publish_level(self, level) -> None:
        if isinstance(level, bool) or not isinstance(level, Real):
            raise TypeError(f"no number: {level!r}")
        self.battery_publisher.publish(Float32(data=max(0.0, min(100.0, float(level)))))
