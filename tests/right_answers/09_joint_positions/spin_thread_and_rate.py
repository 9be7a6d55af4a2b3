"""The node spins in a thread of its own; the main thread sends the joints at the pace of a Rate."""

import random
import threading

import rclpy
from rclpy.executors import ExternalShutdownException
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

    def publish_status(self):
        self.status_pub.publish(String(data="operational"))

    def publish_battery(self):
        self.battery_level = max(0.0, self.battery_level - random.uniform(0.1, 0.5))
        self.battery_pub.publish(Float32(data=self.battery_level))


def spin(node):
    try:
        rclpy.spin(node)
    except ExternalShutdownException:
        pass


def main():
    rclpy.init()
    node = HumanoidStatusPublisher()
    spinner = threading.Thread(target=spin, args=(node,))
    spinner.start()
    rate = node.create_rate(0.5)
    try:
        while rclpy.ok():
            rate.sleep()
            node.joint_pub.publish(Float32MultiArray(data=[random.uniform(-3.0, 3.0) for _ in range(12)]))
    except Exception:
        pass
    finally:
        rclpy.try_shutdown()
        spinner.join()


if __name__ == "__main__":
    main()
