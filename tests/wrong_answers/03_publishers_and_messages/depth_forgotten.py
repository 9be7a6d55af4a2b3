# loses: calls_come_back
# says: BatteryPublisher() raised TypeError: Node.create_publisher() missing 1 required positional argument: 'qos_profile'
# says: Add a depth
"""Leaves out the last argument of create_publisher."""

from rclpy.node import Node
from std_msgs.msg import Float32


class BatteryPublisher(Node):
    def __init__(self) -> None:
        super().__init__("battery_publisher")
        self.battery_publisher = self.create_publisher(Float32, "/robot/battery")

    def publish_level(self, level) -> None:
        self.battery_publisher.publish(Float32(data=float(level)))
