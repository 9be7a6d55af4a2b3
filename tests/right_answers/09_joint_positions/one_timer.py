"""One timer with a counter serves all three topics."""

import itertools
import random

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32, Float32MultiArray, String


class HumanoidStatusPublisher(Node):
    def __init__(self):
        super().__init__("humanoid_status_publisher")
        self.battery_level = 100.0
        self.seconds = itertools.count()
        self.status_pub = self.create_publisher(String, "robot/status", 10)
        self.battery_pub = self.create_publisher(Float32, "robot/battery", 10)
        self.joint_pub = self.create_publisher(Float32MultiArray, "robot/joint_positions", 10)
        self.create_timer(1.0, self.tick)

    def tick(self):
        self.status_pub.publish(String(data="operational"))
        if next(self.seconds) % 2 == 0:
            self.battery_level = max(0.0, self.battery_level - random.uniform(0.1, 0.5))
            self.battery_pub.publish(Float32(data=self.battery_level))
            self.joint_pub.publish(Float32MultiArray(data=[random.uniform(-1.0, 1.0) for _ in range(12)]))


def main():
    rclpy.init()
    try:
        rclpy.spin(HumanoidStatusPublisher())
    except KeyboardInterrupt:
        pass


if __name__ == "__main__":
    main()
