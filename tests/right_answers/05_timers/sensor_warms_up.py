"""Sleeps for 1.5 s in __init__, before anything can be published."""

import math
import time

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Float32, String

HEARTBEAT_PERIOD_S = 1.0  # 1 Hz
BATTERY_PERIOD_S = 2.0
TILT_PERIOD_S = 0.2


class VitalSigns(Node):
    def __init__(self) -> None:
        super().__init__("vital_signs")
        self.level = 100.0
        time.sleep(1.5)  # the battery sensor warms up
        self.phase = 0.0
        self.heartbeat_publisher = self.create_publisher(String, "/robot/heartbeat", 10)
        self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)
        self.tilt_publisher = self.create_publisher(Float32, "/robot/tilt", 10)
        self.heartbeat_timer = self.create_timer(HEARTBEAT_PERIOD_S, self.publish_heartbeat)
        self.battery_timer = self.create_timer(BATTERY_PERIOD_S, self.publish_battery)
        self.tilt_timer = self.create_timer(TILT_PERIOD_S, self.publish_tilt)

    def publish_heartbeat(self) -> None:
        self.heartbeat_publisher.publish(String(data="alive"))

    def publish_battery(self) -> None:
        self.level = max(0.0, self.level - 0.5)
        self.battery_publisher.publish(Float32(data=self.level))

    def publish_tilt(self) -> None:
        self.phase += 0.1
        self.tilt_publisher.publish(Float32(data=0.2 * math.sin(self.phase)))


def main(args: list[str] | None = None) -> None:
    rclpy.init(args=args)
    try:
        rclpy.spin(VitalSigns())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
