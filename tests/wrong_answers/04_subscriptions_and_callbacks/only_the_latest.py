# loses: in_order
# skips: bad_kept_back, own_robot_only
# says: what came before that is forgotten
"""A timer passes on what came last, twice a second. What came in between is lost."""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Float32, String


class BatteryMonitor(Node):
    """Stands between the battery sensor and all who want to know the charge."""

    def __init__(self) -> None:
        super().__init__("battery_monitor")
        self.latest: float | None = None
        self.battery_publisher = self.create_publisher(Float32, "/monitor/battery", 10)
        self.alarm_publisher = self.create_publisher(String, "/monitor/alarm", 10)
        self.create_subscription(Float32, "/robot/battery", self.on_battery, 10)
        self.create_timer(0.5, self.send)

    def on_battery(self, message: Float32) -> None:
        if 0.0 <= message.data <= 100.0:
            self.latest = message.data
        else:
            self.alarm_publisher.publish(String(data=f"bad reading: {message.data}"))

    def send(self) -> None:
        if self.latest is not None:
            self.battery_publisher.publish(Float32(data=self.latest))
            self.latest = None


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
