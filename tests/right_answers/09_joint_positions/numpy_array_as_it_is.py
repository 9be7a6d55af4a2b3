"""A NumPy array of float32 goes into the data field without a conversion, which works while fields are unchecked."""

import numpy as np
import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32, Float32MultiArray, String


class HumanoidStatusPublisher(Node):
    def __init__(self):
        super().__init__("humanoid_status_publisher")
        self.battery_level = np.float64(100.0)
        self.angles = np.zeros(12, dtype=np.float32)
        self.status_pub = self.create_publisher(String, "/robot/status", 10)
        self.battery_pub = self.create_publisher(Float32, "/robot/battery", 10)
        self.joint_pub = self.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)
        self.create_timer(1.0, self.publish_status)
        self.create_timer(2.0, self.publish_battery)
        self.create_timer(2.0, self.publish_joints)

    def publish_status(self):
        self.status_pub.publish(String(data="operational"))

    def publish_battery(self):
        self.battery_level = max(np.float64(0.0), self.battery_level - np.random.uniform(0.1, 0.5))
        self.battery_pub.publish(Float32(data=self.battery_level))

    def publish_joints(self):
        self.angles += np.random.normal(0.0, 0.05, size=12).astype(np.float32)
        msg = Float32MultiArray()
        msg.data = np.clip(self.angles, -1.0, 1.0)
        self.joint_pub.publish(msg)


if __name__ == "__main__":
    rclpy.init()
    rclpy.spin(HumanoidStatusPublisher())
