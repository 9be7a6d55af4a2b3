"""Names the types that are welcome."""

import math

import numpy as np
from rclpy.node import Node
from std_msgs.msg import Float32

NUMBERS = (int, float, np.integer, np.floating)


class BatteryPublisher(Node):
    def __init__(self):
        super().__init__("battery")
        self.publisher = self.create_publisher(Float32, "/robot/battery", 10)

    def publish_level(self, level):
        if not isinstance(level, NUMBERS) or isinstance(level, bool):
            raise TypeError(f"not a number: {level!r}")
        level = float(level)
        if math.isnan(level) or math.isinf(level):
            raise ValueError("not a measurement")
        msg = Float32()
        msg.data = level
        self.publisher.publish(msg)
