"""Receive the status publisher's messages, store the latest ones, and warn of a low battery.

Run it with ``python -m lesson_nodes.status_monitor`` and end it with Ctrl-C.
"""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Float32, String

LOW_BATTERY_PERCENT = 20.0


class StatusMonitor(Node):
    """Stores the humanoid's latest status and battery charge.

    Subscriptions:
        /robot/status (std_msgs/String): "operational" or "error".
        /robot/battery (std_msgs/Float32): charge in percent.

    Attributes:
        last_status: The latest status; None before the first one.
        last_battery: The latest charge in percent; None before the first one.
        battery_is_low: Whether the latest charge was below 20 percent.
    """

    def __init__(self) -> None:
        super().__init__("status_monitor")
        self.last_status: str | None = None
        self.last_battery: float | None = None
        self.battery_is_low = False
        self.create_subscription(String, "/robot/status", self.on_status, 10)
        self.create_subscription(Float32, "/robot/battery", self.on_battery, 10)
        self.get_logger().info("Status monitor started")

    def on_status(self, message: String) -> None:
        """Store the status, and log it if it has changed."""
        if message.data != self.last_status:
            self.get_logger().info(f"The robot is {message.data}")
        self.last_status = message.data

    def on_battery(self, message: Float32) -> None:
        """Store the charge, and warn once each time it falls below 20 %."""
        self.last_battery = message.data
        is_low = message.data < LOW_BATTERY_PERCENT
        if is_low and not self.battery_is_low:
            self.get_logger().warning(f"Battery low: {message.data:.1f} %")
        self.battery_is_low = is_low


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(StatusMonitor())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
