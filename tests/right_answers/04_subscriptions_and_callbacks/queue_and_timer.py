"""The callback only collects; a quick timer sends what has come, first in, first out."""

from collections import deque

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Float32, String


class BatteryMonitor(Node):
    def __init__(self) -> None:
        super().__init__("battery_monitor")
        self.waiting: deque[float] = deque()
        self.battery = self.create_publisher(Float32, "monitor/battery", 10)
        self.alarm = self.create_publisher(String, "monitor/alarm", 10)
        self.create_subscription(
            Float32, "robot/battery", lambda message: self.waiting.append(message.data), 10
        )
        self.create_timer(0.05, self.send)

    def send(self) -> None:
        while self.waiting:
            charge = self.waiting.popleft()
            if charge >= 0.0 and charge <= 100.0:
                self.battery.publish(Float32(data=charge))
            else:
                self.alarm.publish(String(data=f"no charge: {charge}"))


def main() -> None:
    rclpy.init()
    try:
        rclpy.spin(BatteryMonitor())
    except (KeyboardInterrupt, ExternalShutdownException):
        rclpy.try_shutdown()


main()
