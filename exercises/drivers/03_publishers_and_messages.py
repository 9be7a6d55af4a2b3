"""Call `publish_level` of the answer's BatteryPublisher with one value after another, and report each call's outcome.

Topics:
    /driver/calls (std_msgs/String), subscription: the arguments, one Python expression per line. The driver waits for
        them before it does anything.
    /driver/report (std_msgs/String), publisher: "made" or "not made: ...". Then, for each call,
        "call 3: publish_level(64)", and "call 3 returned" or "call 3 raised TypeError: ...". Finally, "done". Each
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

sign: Callable[[str, str], str] = globals()["sign"]  # provided by the host; signs a report for a topic

REPORT = "/driver/report"
PACE_S = 0.06  # from one call to the next, so that all calls together take about a second
BREATH_S = 0.01  # so that a call's messages have a later timestamp than its announcement
AT_ONCE = 4  # the call with this number follows the previous one immediately, with a shorter pause
SHORT_BREATH_S = 0.001
PATIENCE_S = 1.0  # for a subscriber, which an answer that publishes on another topic never gets
LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
NAMES = {"np": np, "nan": float("nan"), "inf": float("inf")}
LONGEST_ERROR = 300  # characters
MOST_EARLY = 3  # of these messages are reported


@contextmanager
def sending_noted() -> Iterator[list[object]]:
    """Yield a list to which every value published on /robot/battery while the block runs is added."""
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
    """Create the answer's node. Return the node and "", or None and the reason why the node can't be used."""
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
    """Return an error on one line, as Python prints it."""
    text = " ".join(str(error).split())[:LONGEST_ERROR]
    return f"{type(error).__name__}: {text}" if text else type(error).__name__


class Driver(Node):
    """Makes one call per timer tick, once its reports and the answer's messages have subscribers.

    `early`: the values that the answer's node published while it was created. No subscription can receive these.
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
        """Publish a signed report on /driver/report."""
        self.report_publisher.publish(String(data=sign(REPORT, text)))

    def on_calls(self, message: String) -> None:
        """Store the arguments. Calls begin when the battery's topic has a subscriber, or after a second without one."""
        if not self.expressions:
            self.expressions = message.data.splitlines()
            self.not_before = time.monotonic() + PATIENCE_S

    def on_tick(self) -> None:
        """Report whether the answer's node was created. On each later tick, make one call (on one tick, two)."""
        if not self.expressions or self.report_publisher.get_subscription_count() == 0:
            return
        if self.to_say:
            self.say(self.to_say)
            self.to_say = ""
            # One end of a connection discovers the other end first. Messages that it sends before the other end has
            # discovered it, too, would be lost.
            for level in self.early[:MOST_EARLY]:
                self.say(f"sent before any call: {level}")
            self.early.clear()
            self.report_publisher.wait_for_all_acked(Duration(seconds=PATIENCE_S))
            self.timer.reset()  # otherwise, the calls after a long wait would follow each other too fast
        elif self.usable and self.is_heard():
            self.call_next(BREATH_S)
            if self.called + 1 == AT_ONCE:
                self.call_next(SHORT_BREATH_S)
            if self.called == len(self.expressions):
                self.to_say = "done"
                self.usable = False

    def is_heard(self) -> bool:
        """Return whether all of the answer's publishers have subscribers, or had enough time to get some."""
        if self.called or time.monotonic() > self.not_before:
            return True
        publishers = [
            one for one in getattr(self.battery, "publishers", ()) if one.topic_name.startswith("/robot/")
        ]
        return bool(publishers) and all(one.get_subscription_count() > 0 for one in publishers)

    def call_next(self, breath_s: float) -> None:
        """Announce the next call, wait for `breath_s` s, make the call, and report its outcome."""
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
    """Create the answer's node, and run it along with the driver until Ctrl-C."""
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
