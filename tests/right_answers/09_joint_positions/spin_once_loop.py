"""A loop of spin_once with a timeout, in the place of spin."""

import math
import random

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32, Float32MultiArray, String


class HumanoidStatusPublisher(Node):
    def __init__(self):
        super().__init__("humanoid_status_publisher")
        self.level = 100.0
        self.count = 0
        self.pub_status = self.create_publisher(String, "/robot/status", 10)
        self.pub_battery = self.create_publisher(Float32, "/robot/battery", 10)
        self.pub_joints = self.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)
        self.create_timer(1, self.on_second)
        self.create_timer(2, self.on_battery)
        self.create_timer(2, self.on_joints)

    def on_second(self):
        self.pub_status.publish(String(data="operational"))

    def on_battery(self):
        self.level -= random.uniform(0.1, 0.5)
        self.pub_battery.publish(Float32(data=max(0.0, self.level)))

    def on_joints(self):
        self.count += 1
        self.pub_joints.publish(Float32MultiArray(data=[math.cos(self.count + i / 3) for i in range(12)]))


def main():
    rclpy.init()
    node = HumanoidStatusPublisher()
    while rclpy.ok():
        rclpy.spin_once(node, timeout_sec=0.05)


if __name__ == "__main__":
    main()
