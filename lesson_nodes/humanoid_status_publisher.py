"""Simulate a humanoid robot that publishes its status once a second and its battery charge every two seconds.

Run it with ``python -m lesson_nodes.humanoid_status_publisher`` and end it with Ctrl-C.
"""

import random

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Float32, String

STATUS_PERIOD_S = 1.0
BATTERY_PERIOD_S = 2.0
DRAIN_PERCENT = (0.1, 0.5)


class HumanoidStatusPublisher(Node):
    """Publishes the robot's status and its battery charge.

    Topics:
        /robot/status (std_msgs/String), 1 Hz: "operational", or "error" once the battery is empty.
        /robot/battery (std_msgs/Float32), 0.5 Hz: charge in percent, from 100.0 down to 0.0.

    Args:
        battery_level: Initial charge, in percent (0.0 to 100.0).

    Raises:
        ValueError: The charge is not between 0 and 100 percent.
    """

    def __init__(self, battery_level: float = 100.0) -> None:
        if not 0.0 <= battery_level <= 100.0:
            raise ValueError(
                f"A battery holds 0 to 100 percent, not {battery_level}. Give a number in that range."
            )
        super().__init__("humanoid_status_publisher")
        self.battery_level = float(battery_level)
        self.status_publisher = self.create_publisher(String, "/robot/status", 10)
        self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)
        self.status_timer = self.create_timer(STATUS_PERIOD_S, self.publish_status)
        self.battery_timer = self.create_timer(BATTERY_PERIOD_S, self.publish_battery)
        self.get_logger().info("Humanoid status publisher started")

    def publish_status(self) -> None:
        """Publish whether the robot can work."""
        message = String(data="operational" if self.battery_level > 0.0 else "error")
        self.status_publisher.publish(message)
        self.get_logger().info(f"Status: {message.data}")

    def publish_battery(self) -> None:
        """Drain the simulated battery a little, but never below 0 %, and publish its charge."""
        self.battery_level = max(0.0, self.battery_level - random.uniform(*DRAIN_PERCENT))
        self.battery_publisher.publish(Float32(data=self.battery_level))
        self.get_logger().info(f"Battery: {self.battery_level:.1f} %")


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(HumanoidStatusPublisher())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
