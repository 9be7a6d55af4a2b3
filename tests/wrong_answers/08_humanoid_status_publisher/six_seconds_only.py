# loses: alive_at_end
# skips: ends_cleanly
# thorough: yes
# says: the program ended by itself
"""A humanoid robot that reports its state once a second and its battery every two seconds."""

import random

import time

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32, String

STATUS_PERIOD_S = 1.0  # 1 Hz
BATTERY_PERIOD_S = 2.0
DRAIN_PERCENT = (0.5, 1.5)


class HumanoidStatusPublisher(Node):
    """Publishes the state of the robot and the charge of its battery.

    Topics:
        /robot/status (std_msgs/String), 1 Hz: "operational", or "error" once the battery is empty.
        /robot/battery (std_msgs/Float32), 0.5 Hz: charge in percent, from 100 down to 0.
    """

    def __init__(self) -> None:
        super().__init__("humanoid_status_publisher")
        self.battery_level = 100.0
        self.status_publisher = self.create_publisher(String, "/robot/status", 10)
        self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)
        self.status_timer = self.create_timer(STATUS_PERIOD_S, self.publish_status)
        self.battery_timer = self.create_timer(BATTERY_PERIOD_S, self.publish_battery)
        self.get_logger().info("Humanoid status publisher started")

    def publish_status(self) -> None:
        """Say whether the robot can work."""
        message = String(data="operational" if self.battery_level > 0.0 else "error")
        self.status_publisher.publish(message)
        self.get_logger().info(f"Status: {message.data}")

    def publish_battery(self) -> None:
        """Drain the simulated battery a little, never below empty, and report its charge."""
        self.battery_level = max(0.0, self.battery_level - random.uniform(*DRAIN_PERCENT))
        message = Float32(data=self.battery_level)
        self.battery_publisher.publish(message)
        self.get_logger().info(f"Battery: {self.battery_level:.0f} %")


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C."""
    rclpy.init(args=args)
    humanoid = HumanoidStatusPublisher()
    try:
        end = time.monotonic() + 6.0
        while time.monotonic() < end:
            rclpy.spin_once(humanoid, timeout_sec=0.2)
    except KeyboardInterrupt:
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
