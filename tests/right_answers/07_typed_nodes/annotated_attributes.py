"""The attributes say what they take; an assertion keeps watch at run time."""

from typing import Literal, Protocol, TypeVar, get_args

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Float32, String

BATTERY_PERIOD_S = 1.0
STATUS_PERIOD_S = 2.0
DRAIN_PERCENT = 0.125

Status = Literal["operational", "error"]
Taken = TypeVar("Taken", contravariant=True)


class Sends(Protocol[Taken]):
    """Whatever publishes messages of one type, and of no other."""

    def publish(self, msg: Taken) -> None: ...


class RobotReport(Node):
    """Reports the charge in percent and one word on how the robot is.

    Topics:
        /robot/battery (std_msgs/Float32), 1 Hz: charge in percent.
        /robot/status (std_msgs/String), 0.5 Hz: "operational" or "error".
    """

    def __init__(self) -> None:
        super().__init__("robot_report")
        self.level = 100.0
        self.battery_publisher: Sends[Float32] = self.create_publisher(Float32, "/robot/battery", 10)
        self.status_publisher: Sends[String] = self.create_publisher(String, "/robot/status", 10)
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
        assert isinstance(level, int | float), "a number of percent, please"
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


if __name__ == "__main__":
    main()
