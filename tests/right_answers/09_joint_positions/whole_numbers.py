"""The angles are whole numbers; a float array takes them, other than a single float field."""

import random

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32, Float32MultiArray, String


class HumanoidStatusPublisher(Node):
    def __init__(self):
        super().__init__("humanoid_status_publisher")
        self.battery_level = 100.0
        self.sign = 1
        self.status_pub = self.create_publisher(String, "/robot/status", 10)
        self.battery_pub = self.create_publisher(Float32, "/robot/battery", 10)
        self.joint_pub = self.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)
        self.create_timer(1.0, self.publish_status)
        self.create_timer(2.0, self.publish_battery)
        self.create_timer(2.0, self.publish_joints)

    def publish_status(self):
        self.status_pub.publish(String(data="operational"))

    def publish_battery(self):
        self.battery_level = max(0.0, self.battery_level - random.uniform(0.1, 0.5))
        self.battery_pub.publish(Float32(data=self.battery_level))

    def publish_joints(self):
        self.sign = -self.sign
        self.joint_pub.publish(Float32MultiArray(data=[0, 1, 2, 3, 2, 1, 0, self.sign, -self.sign, 0, 0, 0]))


def main():
    rclpy.init()
    rclpy.spin(HumanoidStatusPublisher())


if __name__ == "__main__":
    main()
