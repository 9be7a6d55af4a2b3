"""The rate of the joints is a parameter in hertz; the program passes its arguments on to ROS."""

import math
import random
import sys

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Float32, Float32MultiArray, String


class HumanoidStatusPublisher(Node):
    def __init__(self) -> None:
        super().__init__("humanoid_status_publisher")
        self.declare_parameter("joint_rate_hz", 0.5)
        self.battery_level = 100.0
        self.status_pub = self.create_publisher(String, "/robot/status", 10)
        self.battery_pub = self.create_publisher(Float32, "/robot/battery", 10)
        self.joint_pub = self.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)
        self.create_timer(1.0, self.publish_status)
        self.create_timer(2.0, self.publish_battery)
        rate_hz = self.get_parameter("joint_rate_hz").get_parameter_value().double_value
        self.create_timer(1.0 / rate_hz, self.publish_joints)

    def publish_status(self) -> None:
        self.status_pub.publish(String(data="operational"))

    def publish_battery(self) -> None:
        self.battery_level = max(0.0, self.battery_level - random.uniform(0.1, 0.5))
        self.battery_pub.publish(Float32(data=self.battery_level))

    def publish_joints(self) -> None:
        seconds, nanoseconds = self.get_clock().now().seconds_nanoseconds()
        phase = (seconds % 60) + nanoseconds / 1e9
        self.joint_pub.publish(Float32MultiArray(data=[math.sin(phase + joint) for joint in range(12)]))


def main(args: list[str]) -> None:
    rclpy.init(args=args)
    try:
        rclpy.spin(HumanoidStatusPublisher())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass


if __name__ == "__main__":
    main(sys.argv)
