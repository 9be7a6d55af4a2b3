"""A method for each type of value, and one that refuses all the rest."""

from functools import singledispatchmethod
from numbers import Integral, Real

import numpy
from rclpy.node import Node
from rclpy.qos import QoSProfile, ReliabilityPolicy
from std_msgs.msg import Float32


class BatteryPublisher(Node):
    def __init__(self):
        super().__init__("battery_publisher")
        qos = QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT)
        self._level_publisher = self.create_publisher(Float32, "/robot/battery", qos)

    @singledispatchmethod
    def publish_level(self, level):
        raise NotImplementedError(f"no way to send a {type(level).__name__}")

    @publish_level.register
    def _(self, level: bool):
        raise TypeError("a yes or no is not a charge")

    @publish_level.register
    def _(self, level: Real):
        if not numpy.isfinite(level):
            raise ValueError("infinite, or no number at all")
        self._level_publisher.publish(Float32(data=float(level)))

    @publish_level.register
    def _(self, level: Integral):
        self._level_publisher.publish(Float32(data=float(level)))
