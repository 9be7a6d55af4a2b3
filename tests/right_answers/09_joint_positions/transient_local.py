"""Transient-local publishers keep the last message for late subscribers."""

import math

import rclpy
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from std_msgs.msg import Float32, Float32MultiArray, String

LATCHED = QoSProfile(
    depth=1,
    reliability=ReliabilityPolicy.RELIABLE,
    durability=DurabilityPolicy.TRANSIENT_LOCAL,
)


class HumanoidStatusPublisher(Node):
    def __init__(self) -> None:
        super().__init__("humanoid_status_publisher")
        self.battery_level = 100.0
        self.tick = 0
        self.status_pub = self.create_publisher(String, "/robot/status", LATCHED)
        self.battery_pub = self.create_publisher(Float32, "/robot/battery", LATCHED)
        self.joint_pub = self.create_publisher(Float32MultiArray, "/robot/joint_positions", LATCHED)
        self.create_timer(1.0, self.publish_status)
        self.create_timer(2.0, self.publish_battery)
        self.create_timer(2.0, self.publish_joints)

    def publish_status(self) -> None:
        self.status_pub.publish(String(data="operational"))

    def publish_battery(self) -> None:
        self.battery_level = max(0.0, self.battery_level * 0.995)
        self.battery_pub.publish(Float32(data=self.battery_level))

    def publish_joints(self) -> None:
        self.tick += 1
        wave = math.sin(self.tick)
        self.joint_pub.publish(Float32MultiArray(data=[0.0] * 4 + [wave, -wave] + [0.2] * 6))


rclpy.init()
rclpy.spin(HumanoidStatusPublisher())
