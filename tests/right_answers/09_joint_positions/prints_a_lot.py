"""A thread prints a thousand lines a second."""

import random
import threading
import time

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32, Float32MultiArray, String


class HumanoidStatusPublisher(Node):
    def __init__(self):
        super().__init__("humanoid_status_publisher")
        self.battery_level = 100.0
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
        self.joint_pub.publish(Float32MultiArray(data=[random.uniform(-1.0, 1.0) for _ in range(12)]))


def chatter():
    line = 0
    while True:
        for _ in range(50):
            line += 1
            print(f"line {line}: the robot thinks aloud")
        time.sleep(0.05)


if __name__ == "__main__":
    rclpy.init()
    threading.Thread(target=chatter, daemon=True).start()
    try:
        rclpy.spin(HumanoidStatusPublisher())
    except KeyboardInterrupt:
        pass
