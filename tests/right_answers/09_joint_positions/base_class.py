"""The old publisher stays untouched; a subclass of it adds the joints."""

import random

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32, Float32MultiArray, String


class HumanoidStatusPublisher(Node):
    def __init__(self, name: str = "humanoid_status_publisher") -> None:
        super().__init__(name)
        self.battery_level = 100.0
        self.status_pub = self.create_publisher(String, "/robot/status", 10)
        self.battery_pub = self.create_publisher(Float32, "/robot/battery", 10)
        self.create_timer(1.0, self.publish_status)
        self.create_timer(2.0, self.publish_battery)

    def publish_status(self) -> None:
        self.status_pub.publish(String(data="operational"))

    def publish_battery(self) -> None:
        self.battery_level = max(0.0, self.battery_level - random.uniform(0.1, 0.5))
        self.battery_pub.publish(Float32(data=self.battery_level))


class MovingHumanoid(HumanoidStatusPublisher):
    def __init__(self) -> None:
        super().__init__("moving_humanoid")
        self.joint_pub = self.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)
        self.create_timer(2.0, self.publish_joints)

    def publish_joints(self) -> None:
        self.joint_pub.publish(Float32MultiArray(data=[random.betavariate(2, 5) for _ in range(12)]))
