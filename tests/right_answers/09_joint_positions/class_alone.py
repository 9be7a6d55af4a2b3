"""Nothing but the class: no main, no init, no spin."""

import random

from rclpy.node import Node
from std_msgs.msg import Float32, Float32MultiArray, String


class HumanoidStatusPublisher(Node):
    def __init__(self) -> None:
        super().__init__("humanoid_status_publisher")
        self.status_pub = self.create_publisher(String, "/robot/status", 10)
        self.battery_pub = self.create_publisher(Float32, "/robot/battery", 10)
        self.joint_pub = self.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)
        self.battery_level = 100.0
        self.create_timer(1.0, self.publish_status)
        self.create_timer(2.0, self.publish_battery)
        self.create_timer(2.0, self.publish_joint_positions)

    def publish_status(self) -> None:
        msg = String()
        msg.data = "operational"
        self.status_pub.publish(msg)

    def publish_battery(self) -> None:
        msg = Float32()
        self.battery_level = max(0.0, self.battery_level - random.uniform(0.1, 0.5))
        msg.data = self.battery_level
        self.battery_pub.publish(msg)

    def publish_joint_positions(self) -> None:
        msg = Float32MultiArray()
        msg.data = [random.uniform(-1.5, 1.5) for _ in range(12)]
        self.joint_pub.publish(msg)
