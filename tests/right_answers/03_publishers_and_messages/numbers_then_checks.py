"""A helper that makes a Python number of NumPy's, a kept last value, and a transient local publisher."""

import math

import numpy as np
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile
from std_msgs.msg import Float32


def as_percent(level: object) -> float:
    if isinstance(level, np.generic):
        level = level.item()
    if type(level) not in (int, float):
        raise TypeError(f"{type(level).__name__} is no number")
    if math.isnan(level) or math.isinf(level):
        raise ValueError("no measurement")
    return float(level)


class BatteryPublisher(Node):
    def __init__(self) -> None:
        super().__init__("battery_publisher")
        qos = QoSProfile(depth=50, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.publisher = self.create_publisher(Float32, "/robot/battery", qos)
        self.last: float | None = None
        self.same = 0

    def publish_level(self, level: object) -> None:
        percent = as_percent(level)
        self.same = self.same + 1 if percent == self.last else 0
        self.last = percent
        self.publisher.publish(Float32(data=percent))
        self.get_logger().debug(f"{percent} %, unchanged for {self.same} calls")
