"""No type variables: one protocol for each of the two publishers, and the class alone."""

import numbers
from typing import Final, Literal, Protocol

from rclpy.node import Node
from std_msgs.msg import Float32, String

AGREED: Final = frozenset({"operational", "error"})


class SendsFloat(Protocol):
    def publish(self, msg: Float32, /) -> None: ...


class SendsText(Protocol):
    def publish(self, msg: String, /) -> None: ...


class RobotReport(Node):
    battery_publisher: SendsFloat
    status_publisher: SendsText

    def __init__(self) -> None:
        Node.__init__(self, "robot_report")
        self.ticks = 0
        self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)
        self.status_publisher = self.create_publisher(String, "/robot/status", 10)
        self.create_timer(1.0, self.on_second)

    def on_second(self) -> None:
        self.ticks += 1
        self.send_battery(100 - self.ticks // 10)
        if self.ticks % 2 == 0:
            self.send_status("operational")

    def send_battery(self, level: float) -> None:
        if not isinstance(level, numbers.Real):
            raise TypeError("a number is needed")
        message = Float32()
        message.data = float(level)
        self.battery_publisher.publish(message)

    def send_status(self, word: Literal["operational", "error"]) -> None:
        if not (isinstance(word, str) and word in AGREED):
            raise TypeError(f"not agreed: {word}")
        message = String()
        message.data = word
        self.status_publisher.publish(message)
