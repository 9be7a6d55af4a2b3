"""The program starts itself a second time; the second process reports the joints."""

import random
import subprocess
import sys

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32, Float32MultiArray, String


class StatusPublisher(Node):
    def __init__(self):
        super().__init__("humanoid_status_publisher")
        self.battery_level = 100.0
        self.status_pub = self.create_publisher(String, "/robot/status", 10)
        self.battery_pub = self.create_publisher(Float32, "/robot/battery", 10)
        self.create_timer(1.0, self.publish_status)
        self.create_timer(2.0, self.publish_battery)

    def publish_status(self):
        self.status_pub.publish(String(data="operational"))

    def publish_battery(self):
        self.battery_level = max(0.0, self.battery_level - random.uniform(0.1, 0.5))
        self.battery_pub.publish(Float32(data=self.battery_level))


class JointPublisher(Node):
    def __init__(self):
        super().__init__("joint_publisher")
        self.joint_pub = self.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)
        self.create_timer(2.0, self.publish_joints)

    def publish_joints(self):
        self.joint_pub.publish(Float32MultiArray(data=[random.uniform(-1.0, 1.0) for _ in range(12)]))


def main():
    is_child = "--joints" in sys.argv
    child = None if is_child else subprocess.Popen([sys.executable, __file__, *sys.argv[1:], "--", "--joints"])
    rclpy.init()
    try:
        rclpy.spin(JointPublisher() if is_child else StatusPublisher())
    except KeyboardInterrupt:
        pass
    finally:
        if child is not None:
            child.terminate()
            child.wait()


if __name__ == "__main__":
    main()
