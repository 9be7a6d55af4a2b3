# loses: numbers_arrive, no_number_refused, look_alikes_refused, not_finite_refused, no_invented_zero
# cause: number.not-converted
# says: an int, returned
"""Switches the field checks on when the message class is there already."""

import os

from rclpy.node import Node
from std_msgs.msg import Float32

os.environ["ROS_PYTHON_CHECK_FIELDS"] = "1"


class BatteryPublisher(Node):
    def __init__(self) -> None:
        super().__init__("battery_publisher")
        self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)

    def publish_level(self, level) -> None:
        self.battery_publisher.publish(Float32(data=level))
