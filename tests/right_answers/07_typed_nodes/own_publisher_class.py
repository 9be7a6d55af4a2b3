"""A publisher of our own, which knows its type and looks at every message."""

from __future__ import annotations

from typing import Generic, Literal, TypeVar

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32, String

T = TypeVar("T")
Word = Literal["operational", "error"]
WORDS: tuple[Word, ...] = ("operational", "error")


class TypedPublisher(Generic[T]):
    def __init__(self, node: Node, kind: type[T], topic: str) -> None:
        self.kind = kind
        self.inner = node.create_publisher(kind, topic, 10)

    def publish(self, message: T) -> None:
        if not isinstance(message, self.kind):
            raise TypeError(f"{self.kind.__name__} wanted, {type(message).__name__} given")
        self.inner.publish(message)


class RobotReport(Node):
    def __init__(self) -> None:
        super().__init__("report")
        self.charge: float = 100.0
        self.battery_publisher: TypedPublisher[Float32] = TypedPublisher(self, Float32, "/robot/battery")
        self.status_publisher: TypedPublisher[String] = TypedPublisher(self, String, "/robot/status")
        self.create_timer(1.0, self.tick)
        self.create_timer(2.0, lambda: self.send_status("operational"))

    def tick(self) -> None:
        self.charge -= 0.1
        self.send_battery(self.charge)

    def send_battery(self, level: float) -> None:
        match level:
            case int() | float():
                self.battery_publisher.publish(Float32(data=float(level)))
            case _:
                raise TypeError(f"no number: {level!r}")

    def send_status(self, word: Word) -> None:
        if word in WORDS:
            self.status_publisher.publish(String(data=word))
        else:
            raise ValueError(word)


def main(args: list[str] | None = None) -> None:
    rclpy.init(args=args)
    rclpy.spin(RobotReport())


if __name__ == "__main__":
    main()
