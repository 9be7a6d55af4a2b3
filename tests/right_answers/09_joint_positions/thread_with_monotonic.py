"""The joints by a thread that keeps real time, status and battery by timers."""

import math
import threading
import time
import random

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node

from std_msgs.msg import Float32, Float32MultiArray, String

STATUS_PERIOD_S = 1.0
BATTERY_PERIOD_S = 2.0
JOINT_PERIOD_S = 2.0
DRAIN_PERCENT = (0.1, 0.5)


class HumanoidStatusPublisher(Node):
    def __init__(self) -> None:
        super().__init__("humanoid_status_publisher")
        self.battery_level = 100.0
        self.phase = 0.0
        self.status_publisher = self.create_publisher(String, "/robot/status", 10)
        self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)
        self.joint_publisher = self.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)
        self.status_timer = self.create_timer(STATUS_PERIOD_S, self.publish_status)
        self.battery_timer = self.create_timer(BATTERY_PERIOD_S, self.publish_battery)
        threading.Thread(target=self.move, daemon=True).start()
        self.get_logger().info("Humanoid status publisher started")

    def publish_status(self) -> None:
        message = String(data="operational" if self.battery_level > 0.0 else "error")
        self.status_publisher.publish(message)
        self.get_logger().info(f"Status: {message.data}")

    def publish_battery(self) -> None:
        self.battery_level = max(0.0, self.battery_level - random.uniform(*DRAIN_PERCENT))
        self.battery_publisher.publish(Float32(data=self.battery_level))
        self.get_logger().info(f"Battery: {self.battery_level:.1f} %")

    def move(self) -> None:
        due = time.monotonic()
        while rclpy.ok():
            self.publish_joints()
            due += JOINT_PERIOD_S
            while time.monotonic() < due:
                time.sleep(0.01)

    def publish_joints(self) -> None:
        self.phase += 0.4
        angles = [0.5 * math.sin(self.phase + 0.3 * joint) for joint in range(12)]
        self.joint_publisher.publish(Float32MultiArray(data=angles))


def main(args: list[str] | None = None) -> None:
    rclpy.init(args=args)
    try:
        rclpy.spin(HumanoidStatusPublisher())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
