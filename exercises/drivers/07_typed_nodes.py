"""Run the answer's RobotReport, and call its methods, correctly and incorrectly, when the judge orders it.

Topics:
    /driver/go (std_msgs/String), subscription: an order with one call per line, such as "send_battery(42)".
    /driver/report (std_msgs/String), publisher: after all of an order's calls, one signed report per call, such as
        "send_battery(42)<tab>returned" or "send_battery('full')<tab>TypeError: ...".
"""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import answer  # type: ignore[import-not-found]  # the student's file
import rclpy
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import Float32, Float64, String

sign: Callable[[str, str], str] = globals()["sign"]  # provided by the host; signs a report for a topic

REPORT = "/driver/report"
LONGEST_ERROR = 200  # characters
NAMES = {"Float32": Float32, "Float64": Float64, "Path": Path, "String": String}


class Driver(Node):
    """Makes the calls of each order, and reports their outcomes."""

    def __init__(self, robot: Any) -> None:
        super().__init__("driver")
        self.robot = robot
        self.report_publisher = self.create_publisher(String, REPORT, 200)
        self.create_subscription(String, "/driver/go", self.on_go, 10)

    def on_go(self, order: String) -> None:
        """Make every call of an order, even if an earlier call raises an exception, and then publish the reports."""
        lines = [f"{call}\t{self.outcome(call)}" for call in order.data.splitlines()]
        for line in lines:  # one message each, because a recording truncates long strings
            self.report_publisher.publish(String(data=sign(REPORT, line)))

    def outcome(self, call: str) -> str:
        """Make a call, and return its outcome on one line."""
        try:
            eval(f"robot.{call}", {"robot": self.robot, **NAMES})
        except Exception as error:
            return f"{type(error).__name__}: {' '.join(str(error).split())}"[:LONGEST_ERROR]
        return "returned"


def main() -> None:
    """Spin the robot and its driver until Ctrl-C. Raise AttributeError if the answer doesn't define RobotReport."""
    if not hasattr(answer, "RobotReport"):
        raise AttributeError("your program has no class RobotReport")
    rclpy.init()
    robot = answer.RobotReport()
    executor = SingleThreadedExecutor()
    for node in (robot, Driver(robot)):
        executor.add_node(node)
    try:
        executor.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
