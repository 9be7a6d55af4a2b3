# loses: calls_come_back
# says: no method publish_level in your file
"""Names the method as it likes."""

from rclpy.node import Node
from std_msgs.msg import Float32


class BatteryPublisher(Node):
    def __init__(self) -> None:
        super().__init__("battery_publisher")
        self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)

    def publish_battery(self, level) -> None:
        self.battery_publisher.publish(Float32(data=float(level)))
