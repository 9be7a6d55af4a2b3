# loses: in_order, no_false_alarm
# skips: bad_kept_back, own_robot_only
# says: comes after a jump
"""Believes that a battery cannot jump. A fresh one has just been put in."""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Float32, String


class BatteryMonitor(Node):
    """Stands between the battery sensor and all who want to know the charge."""

    def __init__(self) -> None:
        super().__init__("battery_monitor")
        self.last: float | None = None
        self.battery_publisher = self.create_publisher(Float32, "/monitor/battery", 10)
        self.alarm_publisher = self.create_publisher(String, "/monitor/alarm", 10)
        self.create_subscription(Float32, "/robot/battery", self.on_battery, 10)

    def on_battery(self, message: Float32) -> None:
        jump = self.last is not None and abs(message.data - self.last) > 10.0
        if 0.0 <= message.data <= 100.0 and not jump:
            self.battery_publisher.publish(message)
        else:
            self.alarm_publisher.publish(String(data=f"bad reading: {message.data}"))
        if 0.0 <= message.data <= 100.0:
            self.last = message.data


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
