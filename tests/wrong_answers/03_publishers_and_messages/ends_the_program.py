# loses: calls_come_back
# says: the program ended by itself at publish_level(None)
# says: raise an error instead
"""Ends the whole program when a value is bad."""

import sys

from rclpy.node import Node
from std_msgs.msg import Float32


class BatteryPublisher(Node):
    def __init__(self) -> None:
        super().__init__("battery_publisher")
        self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)

    def publish_level(self, level) -> None:
        if level is None or isinstance(level, str):
            sys.exit("no charge")
        self.battery_publisher.publish(Float32(data=float(level)))
