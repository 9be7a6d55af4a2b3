"""Arithmetic is the check: what cannot be subtracted from is no number."""

from typing import Literal, Protocol, TypeVar

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Float32, String

BATTERY_PERIOD_S = 1.0
STATUS_PERIOD_S = 2.0
DRAIN_PERCENT = 0.125

Status = Literal["operational", "error"]
Message = TypeVar("Message")
Taken = TypeVar("Taken", contravariant=True)


class Sends(Protocol[Taken]):
    """Whatever publishes messages of one type, and of no other."""

    def publish(self, msg: Taken) -> None: ...


def make_publisher(node: Node, kind: type[Message], topic: str, depth: int = 10) -> Sends[Message]:
    """A publisher that knows which messages it takes: those of `kind`."""
    return node.create_publisher(kind, topic, depth)


class RobotReport(Node):
    """Reports the charge in percent and one word on how the robot is.

    Topics:
        /robot/battery (std_msgs/Float32), 1 Hz: charge in percent.
        /robot/status (std_msgs/String), 0.5 Hz: "operational" or "error".
    """

    def __init__(self) -> None:
        super().__init__("robot_report")
        self.level = 100.0
        self.battery_publisher = make_publisher(self, Float32, "/robot/battery")
        self.status_publisher = make_publisher(self, String, "/robot/status")
        self.create_timer(BATTERY_PERIOD_S, self.report_battery)
        self.create_timer(STATUS_PERIOD_S, self.report_status)

    def report_battery(self) -> None:
        """Drain the simulated battery a little and report it."""
        self.level = max(0.0, self.level - DRAIN_PERCENT)
        self.send_battery(self.level)

    def report_status(self) -> None:
        """Report whether the robot can work."""
        self.send_status("operational" if self.level > 0.0 else "error")

    def send_battery(self, level: float) -> None:
        """Send a charge in percent.

        Raises:
            TypeError: it is no number.
        """
        level = level - 0.0  # raises for what is no number, and makes a float of an int
        self.battery_publisher.publish(Float32(data=level))

    def send_status(self, word: Status) -> None:
        """Send one of the two agreed words.

        Raises:
            ValueError: it is another one.
        """
        assert word in ("operational", "error"), f"{word!r} is not agreed"
        self.status_publisher.publish(String(data=word))


def main() -> None:
    """Run the node until Ctrl-C or a request to end."""
    rclpy.init()
    try:
        rclpy.spin(RobotReport())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
