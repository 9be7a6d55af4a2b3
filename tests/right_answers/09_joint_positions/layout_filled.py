"""The layout of the array says what its one dimension is."""

import random

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32, Float32MultiArray, MultiArrayDimension, MultiArrayLayout, String

JOINTS = 12


class HumanoidStatusPublisher(Node):
    def __init__(self) -> None:
        super().__init__("humanoid_status_publisher")
        self.battery_level = 100.0
        dimension = MultiArrayDimension(label="joint", size=JOINTS, stride=JOINTS)
        self.layout = MultiArrayLayout(dim=[dimension], data_offset=0)
        self.status_pub = self.create_publisher(String, "/robot/status", 10)
        self.battery_pub = self.create_publisher(Float32, "/robot/battery", 10)
        self.joint_pub = self.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)
        self.create_timer(1.0, self.publish_status)
        self.create_timer(2.0, self.publish_battery)
        self.create_timer(2.0, self.publish_joints)

    def publish_status(self) -> None:
        self.status_pub.publish(String(data="operational"))

    def publish_battery(self) -> None:
        self.battery_level = max(0.0, self.battery_level - random.uniform(0.1, 0.5))
        self.battery_pub.publish(Float32(data=self.battery_level))

    def publish_joints(self) -> None:
        angles = tuple(random.uniform(-1.0, 1.0) for _ in range(JOINTS))
        self.joint_pub.publish(Float32MultiArray(layout=self.layout, data=angles))


def main() -> None:
    rclpy.init()
    rclpy.spin(HumanoidStatusPublisher())


if __name__ == "__main__":
    main()
