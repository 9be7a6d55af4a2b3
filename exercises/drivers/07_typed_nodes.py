"""Runs the answer's RobotReport, and on a word from the bench uses it correctly and incorrectly, as its callers will.

Topics:
    /driver/go (std_msgs/String), heard: an order, with a call on each line, such as "send_battery(42)".
    /driver/report (std_msgs/String), published after them: a line for each call, "send_battery(42)<tab>returned" or
        "send_battery('full')<tab>TypeError: ...".
"""

from pathlib import Path
from typing import Any

import answer  # type: ignore[import-not-found]  # the student's file
import rclpy
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import Float32, Float64, String

LONGEST_ERROR = 200  # characters
NAMES = {"Float32": Float32, "Float64": Float64, "Path": Path, "String": String}


class Driver(Node):
    """Makes all calls when it is told to, and reports what became of them."""

    def __init__(self, robot: Any) -> None:
        super().__init__("driver")
        self.robot = robot
        self.report_publisher = self.create_publisher(String, "/driver/report", 10)
        self.create_subscription(String, "/driver/go", self.on_go, 10)

    def on_go(self, order: String) -> None:
        """Make every call, whatever the others did."""
        lines = [f"{call}\t{self.outcome(call)}" for call in order.data.splitlines()]
        self.report_publisher.publish(String(data="\n".join(lines)))

    def outcome(self, call: str) -> str:
        """What became of a call, on one line."""
        try:
            eval(f"robot.{call}", {"robot": self.robot, **NAMES})
        except Exception as error:
            return f"{type(error).__name__}: {' '.join(str(error).split())}"[:LONGEST_ERROR]
        return "returned"


def main() -> None:
    """Spin the robot and its driver until Ctrl-C."""
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
