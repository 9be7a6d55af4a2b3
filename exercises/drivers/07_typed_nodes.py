"""Runs the answer's RobotReport, and on a word from the bench uses it correctly and incorrectly, as its callers will.

Topics:
    /driver/go (std_msgs/String), heard: each one is an order to make all calls, in their order.
    /driver/report (std_msgs/String), published after them: one for each call, "send_battery(42)<tab>returned" or
        "send_battery('full')<tab>TypeError: ...", signed.
"""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import answer  # type: ignore[import-not-found]  # the student's file
import rclpy
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import Float32, Float64, String

sign: Callable[[str, str], str] = globals()["sign"]  # the host has put it here: it signs a report for a topic

REPORT = "/driver/report"
LONGEST_ERROR = 200  # characters


def calls(robot: Any) -> list[tuple[str, Callable[[], object]]]:
    """What is called, and as one would write it. One number is sent twice in a row."""
    return [
        ("send_battery(42)", lambda: robot.send_battery(42)),
        ("send_battery(55.25)", lambda: robot.send_battery(55.25)),
        ("send_battery(0.0)", lambda: robot.send_battery(0.0)),
        ("send_battery(0.40625)", lambda: robot.send_battery(0.40625)),
        ("send_battery(33.328125)", lambda: robot.send_battery(33.328125)),
        ("send_battery(99.9375)", lambda: robot.send_battery(99.9375)),
        ("send_battery(71.5)", lambda: robot.send_battery(71.5)),
        ("send_battery(71.5)", lambda: robot.send_battery(71.5)),
        (
            "battery_publisher.publish(Float32(data=66.75))",
            lambda: robot.battery_publisher.publish(Float32(data=66.75)),
        ),
        ("send_battery('full')", lambda: robot.send_battery("full")),
        ("send_battery('87.5')", lambda: robot.send_battery("87.5")),
        ("send_battery(b'87.5')", lambda: robot.send_battery(b"87.5")),
        ("send_battery(None)", lambda: robot.send_battery(None)),
        ("send_battery([50.0])", lambda: robot.send_battery([50.0])),
        ("send_battery((50.0,))", lambda: robot.send_battery((50.0,))),
        ("send_status('error')", lambda: robot.send_status("error")),
        ("send_status('operatoinal')", lambda: robot.send_status("operatoinal")),
        ("send_status(3)", lambda: robot.send_status(3)),
        ("send_status(None)", lambda: robot.send_status(None)),
        ("send_status(b'error')", lambda: robot.send_status(b"error")),
        ("send_status(Path('error'))", lambda: robot.send_status(Path("error"))),
        ("send_status('Error')", lambda: robot.send_status("Error")),
        ("send_status(' error')", lambda: robot.send_status(" error")),
        ("send_status('error\\n')", lambda: robot.send_status("error\n")),
        ("send_status('oper')", lambda: robot.send_status("oper")),
        ("send_status('error: arm')", lambda: robot.send_status("error: arm")),
        ("send_status('charging')", lambda: robot.send_status("charging")),
        ("send_status('')", lambda: robot.send_status("")),
        (
            "status_publisher.publish(String(data='error'))",
            lambda: robot.status_publisher.publish(String(data="error")),
        ),
        ("battery_publisher.publish(String())", lambda: robot.battery_publisher.publish(String())),
        (
            "battery_publisher.publish(Float64(data=12.5))",
            lambda: robot.battery_publisher.publish(Float64(data=12.5)),
        ),
        ("status_publisher.publish(Float32())", lambda: robot.status_publisher.publish(Float32())),
        ("battery_publisher.publish(12.5)", lambda: robot.battery_publisher.publish(12.5)),
        ("status_publisher.publish('oper')", lambda: robot.status_publisher.publish("oper")),
        ("battery_publisher.publish(None)", lambda: robot.battery_publisher.publish(None)),
        ("status_publisher.publish(None)", lambda: robot.status_publisher.publish(None)),
    ]


class Driver(Node):
    """Makes all calls when it is told to, and reports what became of them."""

    def __init__(self, robot: Any) -> None:
        super().__init__("driver")
        self.robot = robot
        self.report_publisher = self.create_publisher(String, REPORT, 200)
        self.create_subscription(String, "/driver/go", self.on_go, 10)

    def on_go(self, _: String) -> None:
        """Make every call, whatever the others did."""
        for report in [f"{text}\t{self.outcome(call)}" for text, call in calls(self.robot)]:
            self.report_publisher.publish(String(data=sign(REPORT, report)))

    @staticmethod
    def outcome(call: Callable[[], object]) -> str:
        """What became of a call, on one line."""
        try:
            call()
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
