"""A base class for all typed nodes of a project, checks left to the message, and hints as text."""

from typing import TYPE_CHECKING, Literal, Protocol, TypeAlias, TypeVar, cast

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Float32, String

if TYPE_CHECKING:
    from collections.abc import Callable

M = TypeVar("M")
M_in = TypeVar("M_in", contravariant=True)
Status: TypeAlias = Literal["operational", "error"]


class Sends(Protocol[M_in]):
    def publish(self, msg: M_in) -> None: ...


class TypedNode(Node):
    def typed_publisher(self, kind: "type[M]", topic: str) -> "Sends[M]":
        return cast("Sends[M]", self.create_publisher(kind, topic, 10))

    def every(self, seconds: float, what: "Callable[[], None]") -> None:
        self.create_timer(seconds, what)


class RobotReport(TypedNode):
    def __init__(self, *, start: float = 90.0) -> None:
        super().__init__("robot_report")
        self._level = start
        self._battery = self.typed_publisher(Float32, "/robot/battery")
        self._status = self.typed_publisher(String, "/robot/status")
        self.every(1.0, self.report_battery)
        self.every(2.0, self.report_status)

    @property
    def battery_publisher(self) -> Sends[Float32]:
        return self._battery

    @property
    def status_publisher(self) -> Sends[String]:
        return self._status

    def report_battery(self) -> None:
        self._level *= 0.999
        self.send_battery(self._level)

    def report_status(self) -> None:
        word: Status = "operational" if self._level else "error"
        self.send_status(word)

    def send_battery(self, level: float) -> None:
        if isinstance(level, int):
            level = float(level)
        self.battery_publisher.publish(Float32(data=level, check_fields=True))

    def send_status(self, word: Status) -> None:
        {"operational": self._say, "error": self._say}[word](word)

    def _say(self, word: Status) -> None:
        self.status_publisher.publish(String(data=word, check_fields=True))


if __name__ == "__main__":
    rclpy.init()
    try:
        rclpy.spin(RobotReport())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()
