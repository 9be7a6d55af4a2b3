"""Converts first, and refuses by hand what float() should not have taken."""

from math import isfinite

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32


class BatteryPublisher(Node):
    def __init__(self) -> None:
        super().__init__("battery_publisher", namespace="/robot")
        self.pub = self.create_publisher(Float32, "battery", 1)

    def publish_level(self, level) -> None:
        if isinstance(level, (str, bytes, bool)):
            raise TypeError(f"{type(level).__name__} is not a charge")
        try:
            charge = float(level)
        except (TypeError, ValueError) as error:
            raise ValueError(f"cannot read {level!r} as a charge") from error
        if not isfinite(charge):
            raise ValueError(f"{charge} is not a charge")
        self.pub.publish(Float32(data=charge))


def main() -> None:
    rclpy.init()
    node = BatteryPublisher()
    node.publish_level(100)
    rclpy.spin(node)


if __name__ == "__main__":
    main()
