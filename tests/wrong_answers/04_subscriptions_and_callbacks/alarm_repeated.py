# loses: one_alarm
# skips: no_false_alarm
# says: alarms for one bad reading
# says: once for each bad reading
"""A timer repeats the alarm, so that nobody misses it."""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Float32, String


class BatteryMonitor(Node):
    """Stands between the battery sensor and all who want to know the charge."""

    def __init__(self) -> None:
        super().__init__("battery_monitor")
        self.fault = ""
        self.battery_publisher = self.create_publisher(Float32, "/monitor/battery", 10)
        self.alarm_publisher = self.create_publisher(String, "/monitor/alarm", 10)
        self.create_subscription(Float32, "/robot/battery", self.on_battery, 10)
        self.create_timer(0.2, self.warn)

    def on_battery(self, message: Float32) -> None:
        if 0.0 <= message.data <= 100.0:
            self.battery_publisher.publish(message)
        else:
            self.fault = f"bad reading: {message.data}"

    def warn(self) -> None:
        if self.fault:
            self.alarm_publisher.publish(String(data=self.fault))


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
