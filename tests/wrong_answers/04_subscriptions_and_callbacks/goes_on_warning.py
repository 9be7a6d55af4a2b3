# loses: no_false_alarm
# says: raised for what comes after it
"""Passes good readings on, but the alarm sounds with each of them until somebody restarts it."""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Float32, String


class BatteryMonitor(Node):
    """Stands between the battery sensor and all who want to know the charge."""

    def __init__(self) -> None:
        super().__init__("battery_monitor")
        self.broken = False
        self.battery_publisher = self.create_publisher(Float32, "/monitor/battery", 10)
        self.alarm_publisher = self.create_publisher(String, "/monitor/alarm", 10)
        self.create_subscription(Float32, "/robot/battery", self.on_battery, 10)

    def on_battery(self, message: Float32) -> None:
        good = 0.0 <= message.data <= 100.0
        self.broken = self.broken or not good
        if good:
            self.battery_publisher.publish(message)
        if self.broken:
            self.alarm_publisher.publish(String(data=f"sensor broken, it says {message.data}"))


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
