# loses: battery_topic
# skips: in_order, bad_kept_back, own_robot_only
# says: your node publishes /robot/battery
# says: hears itself
"""Publishes where it listens, and so hears itself, again and again."""

import time

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Float32, String


class BatteryMonitor(Node):
    """Stands between the battery sensor and all who want to know the charge."""

    def __init__(self) -> None:
        super().__init__("battery_monitor")
        self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 1000)
        self.alarm_publisher = self.create_publisher(String, "/monitor/alarm", 1000)
        self.create_subscription(Float32, "/robot/battery", self.on_battery, 1000)

    def on_battery(self, message: Float32) -> None:
        if 0.0 <= message.data <= 100.0:
            time.sleep(0.005)  # smooths the reading
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
