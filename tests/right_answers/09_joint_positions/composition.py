"""Composition: an ordinary class that owns a node made by rclpy.create_node."""

import math
import random

import rclpy
from std_msgs.msg import Float32, Float32MultiArray, String


class Humanoid:
    def __init__(self) -> None:
        self.node = rclpy.create_node("humanoid_status_publisher")
        self.charge = 100.0
        self.step = 0
        self.status = self.node.create_publisher(String, "/robot/status", 10)
        self.battery = self.node.create_publisher(Float32, "/robot/battery", 10)
        self.joints = self.node.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)
        self.node.create_timer(1.0, self.say_status)
        self.node.create_timer(2.0, self.say_battery)
        self.node.create_timer(2.0, self.say_joints)

    def say_status(self) -> None:
        self.status.publish(String(data="operational"))

    def say_battery(self) -> None:
        self.charge = max(0.0, self.charge - random.uniform(0.1, 0.5))
        self.battery.publish(Float32(data=self.charge))

    def say_joints(self) -> None:
        self.step += 1
        angles = [0.8 * math.sin(0.6 * self.step + joint) for joint in range(12)]
        self.joints.publish(Float32MultiArray(data=angles))


rclpy.init()
robot = Humanoid()
try:
    rclpy.spin(robot.node)
except KeyboardInterrupt:
    pass
