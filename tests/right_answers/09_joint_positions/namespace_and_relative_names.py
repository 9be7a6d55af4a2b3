"""The node lives in the namespace robot and its topics have relative names; it also has another node name."""

import math

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32, Float32MultiArray, String


class Body(Node):
    def __init__(self):
        super().__init__("body", namespace="robot")
        self.percent = 64.0
        self.status_out = self.create_publisher(String, "status", 10)
        self.battery_out = self.create_publisher(Float32, "battery", 10)
        self.joints_out = self.create_publisher(Float32MultiArray, "joint_positions", 10)
        self.create_timer(1.0, lambda: self.status_out.publish(String(data="operational")))
        self.create_timer(2.0, self.tell_battery)
        self.create_timer(2.0, self.tell_joints)

    def tell_battery(self):
        self.percent -= 0.25
        self.battery_out.publish(Float32(data=self.percent))

    def tell_joints(self):
        now = self.get_clock().now().nanoseconds / 1e9
        self.joints_out.publish(Float32MultiArray(data=[math.sin(0.3 * now + 0.5 * i) for i in range(12)]))


def main():
    rclpy.init()
    rclpy.spin(Body())


if __name__ == "__main__":
    main()
