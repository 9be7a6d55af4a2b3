"""Publishes the charge first, and drains the battery after that: the first message says 100 %."""

import random

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Float32, String

STATUS_PERIOD_S = 1.0  # 1 Hz
BATTERY_PERIOD_S = 2.0  # 0.5 Hz
DRAIN_PERCENT = (0.5, 1.5)


class HumanoidStatusPublisher(Node):
    def __init__(self) -> None:
        super().__init__("humanoid_status_publisher")
        self.battery_level = 100.0
        self.status_publisher = self.create_publisher(String, "/robot/status", 10)
        self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)
        self.status_timer = self.create_timer(STATUS_PERIOD_S, self.publish_status)
        self.battery_timer = self.create_timer(BATTERY_PERIOD_S, self.publish_battery)
        self.get_logger().info("Humanoid status publisher started")

    def publish_status(self) -> None:
        message = String(data="operational" if self.battery_level > 0.0 else "error")
        self.status_publisher.publish(message)
        self.get_logger().info(f"Status: {message.data}")

    def publish_battery(self) -> None:
        self.battery_publisher.publish(Float32(data=self.battery_level))
        self.battery_level = max(0.0, self.battery_level - random.uniform(*DRAIN_PERCENT))
        self.get_logger().info(f"Battery: {self.battery_level:.0f} %")


def main(args: list[str] | None = None) -> None:
    rclpy.init(args=args)
    humanoid = HumanoidStatusPublisher()
    try:
        rclpy.spin(humanoid)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        humanoid.destroy_node()
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
