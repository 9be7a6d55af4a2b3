"""The angles stand in an array.array of 32-bit floats that is changed in place."""

import random
from array import array

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32, Float32MultiArray, String


class HumanoidStatusPublisher(Node):
    def __init__(self) -> None:
        super().__init__("humanoid_status_publisher")
        self.battery_level = 100.0
        self.status_msg = String(data="operational")
        self.battery_msg = Float32()
        self.joint_msg = Float32MultiArray(data=array("f", [0.0] * 12))
        self.status_pub = self.create_publisher(String, "/robot/status", 10)
        self.battery_pub = self.create_publisher(Float32, "/robot/battery", 10)
        self.joint_pub = self.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)
        self.create_timer(1.0, self.publish_status)
        self.create_timer(2.0, self.publish_battery)
        self.create_timer(2.0, self.publish_joints)

    def publish_status(self) -> None:
        self.status_pub.publish(self.status_msg)

    def publish_battery(self) -> None:
        self.battery_level = max(0.0, self.battery_level - random.uniform(0.1, 0.5))
        self.battery_msg.data = self.battery_level
        self.battery_pub.publish(self.battery_msg)

    def publish_joints(self) -> None:
        for joint in range(12):
            self.joint_msg.data[joint] = random.triangular(-1.0, 1.0)
        self.joint_pub.publish(self.joint_msg)


def main(args: list[str] | None = None) -> None:
    rclpy.init(args=args)
    try:
        rclpy.spin(HumanoidStatusPublisher())
    except KeyboardInterrupt:
        pass


if __name__ == "__main__":
    main()
