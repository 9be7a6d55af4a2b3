"""Calls `publish_level` of the answer's BatteryPublisher with one value after another, and says what became of each.

Topics:
    /driver/calls (std_msgs/String), heard: the arguments, one Python expression a line. The driver begins with it.
    /driver/report (std_msgs/String), published once the arguments are there: "made" or "not made: ...", then for each
        call "call 3: publish_level(64)", and "call 3 returned" or "call 3 raised TypeError: ...", at last "done". Each
        report is signed.
"""

import time
import traceback
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import answer  # type: ignore[import-not-found]  # the student's file
import numpy as np
import rclpy
from rclpy.duration import Duration
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.node import Node
from rclpy.publisher import Publisher
from rclpy.qos import DurabilityPolicy, QoSProfile
from std_msgs.msg import String

sign: Callable[[str, str], str] = globals()["sign"]  # the host has put it here: it signs a report for a topic

REPORT = "/driver/report"
PACE_S = 0.06  # from one call to the next: all of them take about a second
BREATH_S = 0.01  # what a call sends must carry a later time stamp than its announcement
AT_ONCE = 4  # the call with this number follows the one before at once, with a shorter breath
SHORT_BREATH_S = 0.001
PATIENCE_S = 1.0  # for a listener; an answer that publishes elsewhere never gets one
LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
NAMES = {"np": np, "nan": float("nan"), "inf": float("inf")}
LONGEST_ERROR = 300  # characters
MOST_EARLY = 3  # of these messages are reported


@contextmanager
def sending_noted() -> Iterator[list[object]]:
    """Note what is published on the battery's topic meanwhile."""
    noted: list[object] = []
    publish = Publisher.publish

    def publish_and_note(publisher: Publisher, message: Any) -> None:
        publish(publisher, message)
        if publisher.topic_name == "/robot/battery":
            noted.append(getattr(message, "data", None))

    Publisher.publish = publish_and_note  # type: ignore[method-assign, assignment]
    try:
        yield noted
    finally:
        Publisher.publish = publish  # type: ignore[method-assign]


def make_battery() -> tuple[Any, str]:
    """The answer's node, and in words what keeps it from being used ("" if nothing does)."""
    make = getattr(answer, "BatteryPublisher", None)
    if make is None:
        return None, "no class BatteryPublisher"
    try:
        battery = make()
    except Exception as error:
        traceback.print_exc()
        return None, f"BatteryPublisher() raised {in_words(error)}"
    if not callable(getattr(battery, "publish_level", None)):
        return battery, "no method publish_level"
    return battery, ""


def in_words(error: Exception) -> str:
    """An error on one line, as Python prints it."""
    text = " ".join(str(error).split())[:LONGEST_ERROR]
    return f"{type(error).__name__}: {text}" if text else type(error).__name__


class Driver(Node):
    """Makes one call at each tick, once somebody listens to what it says and to what the answer says.

    `early`: what the answer's node sent when it was made. No listener can hear that.
    """

    def __init__(self, battery: Any, trouble: str, early: list[object]) -> None:
        super().__init__("driver")
        self.battery = battery
        self.to_say = f"not made: {trouble}" if trouble else "made"
        self.usable = not trouble
        self.early = early
        self.expressions: list[str] = []
        self.called = 0
        self.not_before = 0.0
        self.report_publisher = self.create_publisher(String, REPORT, 200)
        self.create_subscription(String, "/driver/calls", self.on_calls, LATCHED)
        self.timer = self.create_timer(PACE_S, self.on_tick)

    def say(self, text: str) -> None:
        """Say something on /driver/report, signed."""
        self.report_publisher.publish(String(data=sign(REPORT, text)))

    def on_calls(self, message: String) -> None:
        """Take the arguments; begin when the battery's topic is connected, or after a while without."""
        if not self.expressions:
            self.expressions = message.data.splitlines()
            self.not_before = time.monotonic() + PATIENCE_S

    def on_tick(self) -> None:
        """Say how the making went, then make one call, and once two."""
        if not self.expressions or self.report_publisher.get_subscription_count() == 0:
            return
        if self.to_say:
            self.say(self.to_say)
            self.to_say = ""
            # One side of a connection knows of it before the other: what is said in between would be lost.
            for level in self.early[:MOST_EARLY]:
                self.say(f"sent before any call: {level}")
            self.early.clear()
            self.report_publisher.wait_for_all_acked(Duration(seconds=PATIENCE_S))
            self.timer.reset()  # or the calls after a long wait would follow one another faster
        elif self.usable and self.is_heard():
            self.call_next(BREATH_S)
            if self.called + 1 == AT_ONCE:
                self.call_next(SHORT_BREATH_S)
            if self.called == len(self.expressions):
                self.to_say = "done"
                self.usable = False

    def is_heard(self) -> bool:
        """Whether everything that the answer publishes has a listener, or there was time enough for one."""
        if self.called or time.monotonic() > self.not_before:
            return True
        publishers = [
            one for one in getattr(self.battery, "publishers", ()) if one.topic_name.startswith("/robot/")
        ]
        return bool(publishers) and all(one.get_subscription_count() > 0 for one in publishers)

    def call_next(self, breath_s: float) -> None:
        """Call the answer with the next value, so long (s) after announcing it."""
        expression, number = self.expressions[self.called], self.called + 1
        self.called = number
        self.say(f"call {number}: publish_level({expression})")
        time.sleep(breath_s)
        try:
            self.battery.publish_level(eval(expression, dict(NAMES)))
        except Exception as error:
            traceback.print_exc()
            self.say(f"call {number} raised {in_words(error)}")
        else:
            self.say(f"call {number} returned")


def main() -> None:
    """Make the answer's node and run it together with the driver, until Ctrl-C."""
    if not rclpy.ok():
        rclpy.init()
    with sending_noted() as early:
        battery, trouble = make_battery()
    executor = SingleThreadedExecutor()
    executor.add_node(Driver(battery, trouble, early))
    if isinstance(battery, Node):
        executor.add_node(battery)
    try:
        executor.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


main()
