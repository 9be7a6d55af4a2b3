"""Field checks for the whole program, set before the message class comes in. Numbers are made floats before."""

import os

os.environ["ROS_PYTHON_CHECK_FIELDS"] = "1"

from rclpy.node import Node
from std_msgs.msg import Float32


class BatteryPublisher(Node):
    def __init__(self):
        super().__init__("battery_publisher")
        self.battery_pub = self.create_publisher(Float32, "/robot/battery", 10)

    def publish_level(self, level):
        if not isinstance(level, (bool, str)) and hasattr(level, "__float__"):
            level = float(level)
        if level != level or level in (float("inf"), float("-inf")):
            raise ValueError("no measurement")
        self.battery_pub.publish(Float32(data=level))
