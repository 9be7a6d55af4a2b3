# loses: numbers_arrive, refuses_wrong_types, refuses_wrong_words
# says: __name__
# says: never got its turn
"""Reports battery and status of a humanoid. Others send through it, too, and cannot get the types wrong unnoticed."""

from typing import Literal, Protocol, TypeVar, get_args

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
        if not isinstance(level, (int, float)):
            raise TypeError(f"a charge is a number of percent, not {level!r}")
        self.battery_publisher.publish(Float32(data=float(level)))

    def send_status(self, word: Status) -> None:
        """Send one of the two agreed words.

        Raises:
            ValueError: it is another one.
        """
        if word not in get_args(Status):
            raise ValueError(f"a status is one of {get_args(Status)}, not {word!r}")
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


main()
