# loses: alive_at_end
# thorough: yes
# says: ended by itself
"""The program ends after six real seconds: when robot time is over, and before eight real ones are."""

import math
import random
import time

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32, Float32MultiArray, String


class HumanoidStatusPublisher(Node):
    def __init__(self):
        super().__init__("humanoid_status_publisher")
        self.battery_level = 100.0
        self.step = 0
        self.status_pub = self.create_publisher(String, "/robot/status", 10)
        self.battery_pub = self.create_publisher(Float32, "/robot/battery", 10)
        self.joint_pub = self.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)
        self.status_timer = self.create_timer(1.0, self.publish_status)
        self.battery_timer = self.create_timer(2.0, self.publish_battery)
        self.joint_timer = self.create_timer(2.0, self.publish_joints)

    def publish_status(self):
        self.status_pub.publish(String(data="operational"))

    def publish_battery(self):
        self.battery_level = max(0.0, self.battery_level - random.uniform(0.1, 0.5))
        self.battery_pub.publish(Float32(data=self.battery_level))

    def publish_joints(self):
        self.step += 1
        angles = [0.5 * math.sin(0.7 * self.step + joint) for joint in range(12)]
        self.joint_pub.publish(Float32MultiArray(data=angles))


def main(args=None):
    rclpy.init(args=args)
    node = HumanoidStatusPublisher()
    try:
        end = time.monotonic() + 6.0
        while time.monotonic() < end:
            rclpy.spin_once(node, timeout_sec=0.1)
    except KeyboardInterrupt:
        pass


if __name__ == "__main__":
    main()
