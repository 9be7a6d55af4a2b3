# loses: twelve_values, finite_in_range, joints_move, joint_rate
# says: no message
"""The joints are published once, in the constructor, before anybody listens."""

import math
import random

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32, Float32MultiArray, String


class HumanoidStatusPublisher(Node):
    def __init__(self):
        super().__init__("humanoid_status_publisher")
        self.battery_level = 100.0
        self.step = 0
        self.joint_pub = self.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)
        self.publish_joints()
        self.status_pub = self.create_publisher(String, "/robot/status", 10)
        self.battery_pub = self.create_publisher(Float32, "/robot/battery", 10)
        self.status_timer = self.create_timer(1.0, self.publish_status)
        self.battery_timer = self.create_timer(2.0, self.publish_battery)

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
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass


if __name__ == "__main__":
    main()
