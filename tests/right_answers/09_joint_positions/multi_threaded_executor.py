"""A MultiThreadedExecutor, each timer in a callback group of its own; battery and joints share a random walk."""

import random

import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import Float32, Float32MultiArray, String


class HumanoidStatusPublisher(Node):
    def __init__(self) -> None:
        super().__init__("humanoid_status_publisher")
        self.battery_level = 87.5
        self.angles = [0.0] * 12
        self.status_pub = self.create_publisher(String, "/robot/status", 10)
        self.battery_pub = self.create_publisher(Float32, "/robot/battery", 10)
        self.joint_pub = self.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)
        for period, callback in (
            (1.0, self.publish_status),
            (2.0, self.publish_battery),
            (2.0, self.publish_joints),
        ):
            self.create_timer(period, callback, callback_group=MutuallyExclusiveCallbackGroup())

    def publish_status(self) -> None:
        self.status_pub.publish(String(data="operational"))

    def publish_battery(self) -> None:
        self.battery_level = max(0.0, self.battery_level - random.uniform(0.1, 0.5))
        self.battery_pub.publish(Float32(data=self.battery_level))

    def publish_joints(self) -> None:
        self.angles = [max(-1.0, min(1.0, angle + random.gauss(0.0, 0.1))) for angle in self.angles]
        self.joint_pub.publish(Float32MultiArray(data=self.angles))


def main() -> None:
    rclpy.init()
    executor = MultiThreadedExecutor(num_threads=3)
    executor.add_node(HumanoidStatusPublisher())
    try:
        executor.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
