# loses: in_order
# skips: bad_kept_back, own_robot_only
# says: came where
# says: Publish each one inside the callback
"""Collects readings in a list, and sends the newest first."""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Float32, String


class BatteryMonitor(Node):
    """Stands between the battery sensor and all who want to know the charge."""

    def __init__(self) -> None:
        super().__init__("battery_monitor")
        self.waiting: list[float] = []
        self.battery_publisher = self.create_publisher(Float32, "/monitor/battery", 10)
        self.alarm_publisher = self.create_publisher(String, "/monitor/alarm", 10)
        self.create_subscription(Float32, "/robot/battery", self.on_battery, 10)
        self.create_timer(0.5, self.send)

    def on_battery(self, message: Float32) -> None:
        if 0.0 <= message.data <= 100.0:
            self.waiting.append(message.data)
        else:
            self.alarm_publisher.publish(String(data=f"bad reading: {message.data}"))

    def send(self) -> None:
        while self.waiting:
            self.battery_publisher.publish(Float32(data=self.waiting.pop()))


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C."""
    rclpy.init(args=args)
    try:
        rclpy.spin(BatteryMonitor())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
