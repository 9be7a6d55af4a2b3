"""Writes large values in groups of three digits, as 1,234.5, and others with an exponent, as 1.235e+02."""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Float32, String


class Monitor(Node):
    def __init__(self) -> None:
        super().__init__("battery_monitor")
        self.good_publisher = self.create_publisher(Float32, "/monitor/battery", 10)
        self.alarm_publisher = self.create_publisher(String, "/monitor/alarm", 10)
        self.create_subscription(Float32, "/robot/battery", self.on_reading, 10)

    def on_reading(self, message: Float32) -> None:
        if 0.0 <= message.data <= 100.0:
            self.good_publisher.publish(message)
        else:
            notation = ",.1f" if abs(message.data) >= 1000.0 else ".3e"
            self.alarm_publisher.publish(String(data=f"impossible charge: {message.data:{notation}} %"))


def main() -> None:
    rclpy.init()
    try:
        rclpy.spin(Monitor())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
