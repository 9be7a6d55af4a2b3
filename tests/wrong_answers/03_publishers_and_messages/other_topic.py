# loses: battery_topic
# says: your node publishes /battery, and nothing on /robot/battery
# says: The namespace /robot is missing
"""Leaves out the first half of the name."""

from rclpy.node import Node
from std_msgs.msg import Float32


class BatteryPublisher(Node):
    def __init__(self) -> None:
        super().__init__("battery_publisher")
        self.battery_publisher = self.create_publisher(Float32, "battery", 10)

    def publish_level(self, level) -> None:
        self.battery_publisher.publish(Float32(data=float(level)))
