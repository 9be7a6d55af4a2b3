"""Best-effort publishers with the sensor data profile, as sensors often have."""

import random

import rclpy
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from std_msgs.msg import Float32, Float32MultiArray, String


class HumanoidStatusPublisher(Node):
    def __init__(self) -> None:
        super().__init__("humanoid_status_publisher")
        self.battery_level = 99.0
        self.status_pub = self.create_publisher(String, "/robot/status", qos_profile_sensor_data)
        self.battery_pub = self.create_publisher(Float32, "/robot/battery", qos_profile_sensor_data)
        self.joint_pub = self.create_publisher(
            Float32MultiArray, "/robot/joint_positions", qos_profile_sensor_data
        )
        self.create_timer(1.0, self.publish_status)
        self.create_timer(2.0, self.publish_battery_and_joints)

    def publish_status(self) -> None:
        self.status_pub.publish(String(data="operational" if self.battery_level > 0.0 else "error"))

    def publish_battery_and_joints(self) -> None:
        self.battery_level = max(0.0, self.battery_level - random.uniform(0.1, 0.5))
        self.battery_pub.publish(Float32(data=self.battery_level))
        self.joint_pub.publish(Float32MultiArray(data=[random.uniform(-2.0, 2.0) for _ in range(12)]))


def main() -> None:
    rclpy.init()
    try:
        rclpy.spin(HumanoidStatusPublisher())
    except KeyboardInterrupt:
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
