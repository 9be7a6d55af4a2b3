# loses: in_order, one_alarm
# skips: bad_kept_back, no_false_alarm, own_robot_only
# says: cannot convert float NaN to integer
# says: 11 of 19 good readings
"""Logs whole percents. There is no whole number for nan, and an error in a callback ends the program."""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Float32, String


class BatteryMonitor(Node):
    """Stands between the battery sensor and all who want to know the charge."""

    def __init__(self) -> None:
        super().__init__("battery_monitor")
        self.battery_publisher = self.create_publisher(Float32, "/monitor/battery", 10)
        self.alarm_publisher = self.create_publisher(String, "/monitor/alarm", 10)
        self.create_subscription(Float32, "/robot/battery", self.on_battery, 10)

    def on_battery(self, message: Float32) -> None:
        self.get_logger().info(f"{int(message.data)} %")
        if 0.0 <= message.data <= 100.0:
            self.battery_publisher.publish(message)
        else:
            self.alarm_publisher.publish(String(data=f"bad reading: {message.data}"))


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
