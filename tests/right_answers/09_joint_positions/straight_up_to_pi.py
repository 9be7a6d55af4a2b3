"""Wide movements, clipped to ±π: the nearest 32-bit float to π is a little larger than math.pi."""

import math
import random

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
        wanted = [math.pi, -math.pi] + [random.gauss(0.0, 3.0) for _ in range(10)]
        angles = [max(-math.pi, min(math.pi, angle)) for angle in wanted]
        self.joint_pub.publish(Float32MultiArray(data=angles))


def main():
    rclpy.init()
    try:
        rclpy.spin(HumanoidStatusPublisher())
    except KeyboardInterrupt:
        pass


if __name__ == "__main__":
    main()
