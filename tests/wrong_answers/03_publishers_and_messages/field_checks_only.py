# loses: numbers_arrive, not_finite_refused
# cause: number.refused
# says: AssertionError: The 'data' field must be of type 'float'
"""Leaves all to the field checks of ROS, switched on in time."""

import os

os.environ["ROS_PYTHON_CHECK_FIELDS"] = "1"

from rclpy.node import Node
from std_msgs.msg import Float32


class BatteryPublisher(Node):
    def __init__(self) -> None:
        super().__init__("battery_publisher")
        self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)

    def publish_level(self, level) -> None:
        self.battery_publisher.publish(Float32(data=level))
