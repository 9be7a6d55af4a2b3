# loses: floats_arrive
# skips: zero_arrives, numbers_arrive, no_number_refused, look_alikes_refused, not_finite_refused, no_invented_zero
# says: raised TypeError: Expected <class 'std_msgs.msg._float32.Float32'>, got <class 'float'>
# says: Make the message first
"""Publishes the number, and not a message that holds it."""

from rclpy.node import Node
from std_msgs.msg import Float32


class BatteryPublisher(Node):
    def __init__(self) -> None:
        super().__init__("battery_publisher")
        self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)

    def publish_level(self, level) -> None:
        self.battery_publisher.publish(float(level))
