"""Checks in a function of its own, the publisher in a base class, and a start that init is called for."""

import math
import numbers

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32

rclpy.init()


class NoCharge(Exception):
    """Somebody gave what is no charge."""


def charge_from(level) -> float:
    if type(level) is bool:
        raise NoCharge("a bool")
    if not isinstance(level, numbers.Number):
        raise NoCharge(f"{type(level)}")
    charge = float(level)
    if not math.isfinite(charge):
        raise NoCharge("not finite")
    return charge


class FloatPublisher(Node):
    def __init__(self, name, topic):
        super().__init__(name)
        self.float_publisher = self.create_publisher(Float32, topic, 10)

    def send(self, value):
        self.float_publisher.publish(Float32(data=value))


class BatteryPublisher(FloatPublisher):
    def __init__(self):
        super().__init__("battery_publisher", "/robot/battery")
        self.last = None

    def publish_level(self, level):
        self.last = charge_from(level)
        self.send(self.last)
