"""Small dataclasses that hold a typed function; Optional and Union as older code writes them."""

from dataclasses import dataclass
from typing import Callable, Generic, Literal, Optional, TypeVar, Union

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32, String

M = TypeVar("M")


@dataclass(frozen=True)
class Channel(Generic[M]):
    publish: Callable[[M], None]


class RobotReport(Node):
    def __init__(self, name: Optional[str] = None) -> None:
        super().__init__(name or "robot_report")
        self.level: float = 100.0
        self.battery_publisher: Channel[Float32] = Channel(
            self.create_publisher(Float32, "/robot/battery", 10).publish
        )
        self.status_publisher: Channel[String] = Channel(
            self.create_publisher(String, "/robot/status", 10).publish
        )
        self.battery_timer = self.create_timer(1.0, self.report_battery)
        self.status_timer = self.create_timer(1 / 0.5, self.report_status)

    def report_battery(self) -> None:
        self.level = max(self.level - 0.01, 0.0)
        self.send_battery(self.level)

    def report_status(self) -> None:
        if self.level > 0:
            self.send_status("operational")
        else:
            self.send_status("error")

    def send_battery(self, level: Union[int, float]) -> None:
        if type(level) not in (int, float):
            raise ValueError(f"{level!r} is no charge")
        self.battery_publisher.publish(Float32(data=level * 1.0))

    def send_status(self, word: Literal["operational", "error"]) -> None:
        if word != "operational" and word != "error":
            raise ValueError(f"{word!r} is no status")
        self.status_publisher.publish(String(data=word))


def main() -> None:
    rclpy.init()
    rclpy.spin(RobotReport())


if __name__ == "__main__":
    main()
