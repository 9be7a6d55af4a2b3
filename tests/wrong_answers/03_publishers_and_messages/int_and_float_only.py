# loses: numbers_arrive
# says: publish_level(np.float32(12.5)) raised TypeError
# says: numbers.Real
"""Refuses what comes from NumPy."""

import math

from rclpy.node import Node
from std_msgs.msg import Float32


class BatteryPublisher(Node):
    def __init__(self) -> None:
        super().__init__("battery_publisher")
        self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)

    def publish_level(self, level) -> None:
        if not isinstance(level, (int, float)) or isinstance(level, bool):
            raise TypeError(f"{type(level).__name__} is not a number")
        if not math.isfinite(level):
            raise ValueError("not finite")
        self.battery_publisher.publish(Float32(data=float(level)))
