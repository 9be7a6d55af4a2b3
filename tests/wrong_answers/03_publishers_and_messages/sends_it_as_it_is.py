# loses: numbers_arrive, no_number_refused, look_alikes_refused, not_finite_refused, no_invented_zero
# says: publish_level(64), an int, came back without an error, and 0.0 went out
# says: float(level)
"""Sends what it is given, and trusts the type hint."""

from rclpy.node import Node
from std_msgs.msg import Float32


class BatteryPublisher(Node):
    def __init__(self) -> None:
        super().__init__("battery_publisher")
        self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)

    def publish_level(self, level: float) -> None:
        self.battery_publisher.publish(Float32(data=level))
