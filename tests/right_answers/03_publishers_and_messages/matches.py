"""A match statement; the node is held by a plain class."""

import math

import numpy as np
import rclpy
from std_msgs.msg import Float32


class BatteryPublisher:
    def __init__(self) -> None:
        self.node = rclpy.create_node("battery_publisher")
        self.publisher = self.node.create_publisher(Float32, "/robot/battery", 10)

    def publish_level(self, level: object) -> None:
        match level:
            case bool():
                raise TypeError("a bool")
            case int() | float() | np.number() if math.isfinite(level):
                self.publisher.publish(Float32(data=float(level)))
            case _:
                raise TypeError(f"cannot send {level!r}")
