"""One timer for both topics: the battery goes out with every second status."""

import contextlib
import random

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Float32, String


class HumanoidStatusPublisher(Node):
    def __init__(self) -> None:
        super().__init__("humanoid_status_publisher")
        self.level, self.ticks = 100.0, 0
        self.status_pub = self.create_publisher(String, "/robot/status", 1)
        self.battery_pub = self.create_publisher(Float32, "/robot/battery", 1)
        self.create_timer(1.0, self.tick)

    def tick(self) -> None:
        self.ticks += 1
        self.status_pub.publish(String(data="operational" if self.level > 0 else "error"))
        if self.ticks % 2 == 0:
            self.level = max(0.0, self.level - random.uniform(0.5, 1.5))
            message = Float32()
            message.data = self.level
            self.battery_pub.publish(message)


if __name__ == "__main__":
    rclpy.init()
    with contextlib.suppress(KeyboardInterrupt, ExternalShutdownException):
        rclpy.spin(HumanoidStatusPublisher())
    rclpy.try_shutdown()
