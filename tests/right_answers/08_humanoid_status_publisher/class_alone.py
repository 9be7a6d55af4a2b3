"""The class and nothing else: whoever runs it makes the node and spins it."""

import random

from rclpy.node import Node
from std_msgs.msg import Float32, String


class HumanoidStatusPublisher(Node):
    def __init__(self) -> None:
        super().__init__("humanoid_status_publisher")
        self.battery_level = 100.0
        self.status_pub = self.create_publisher(String, "/robot/status", 10)
        self.battery_pub = self.create_publisher(Float32, "/robot/battery", 10)
        self.status_timer = self.create_timer(1.0, self.publish_status)
        self.battery_timer = self.create_timer(2.0, self.publish_battery)

    def publish_status(self) -> None:
        self.status_pub.publish(String(data="operational" if self.battery_level > 0.0 else "error"))

    def publish_battery(self) -> None:
        self.battery_level = max(0.0, self.battery_level - random.uniform(0.5, 1.5))
        self.battery_pub.publish(Float32(data=self.battery_level))
