"""Call the answer's `pump` for each order on /driver/go, and announce the start and the end of each call.

Topics:
    /driver/go (std_msgs/String), subscription: "1 robot 1.5" means that call 1 is pump(robot, 1.5). A repeated order
        has no effect.
    /driver/pump (std_msgs/String), publisher: "begin 1", then "end 1 1.501 0.020 0.001 0.03" or
        "raised 1 TypeError: ...", or "missing" if the answer has no such function. In this example, the call took
        1.501 s. Meanwhile, the program used 0.02 s of CPU time, the calling thread waited 0.001 s for a processor, and
        the virtual machine's host took a processor away for 0.03 s. The driver repeats its last announcement until
        there is a new one.
    /driver/changed (std_msgs/String), publisher: an unwanted change that a call made. "1 1 timer left" means that
        call 1 left a timer behind.

All of these reports are signed. So are the robots' messages, in the label of their first dimension.

Each message of a robot contains the number of the call in which the robot published it, or 0 between calls. So it
doesn't matter when the message arrives on a busy machine. The driver has a separate context, so it can still report
what happened after an answer has shut ROS down.
"""

import concurrent.futures.thread
import functools
import os
import sys
import threading
import time
import traceback
from collections.abc import Callable, Iterable
from time import monotonic
from typing import Any

import rclpy
import rclpy.executors
from rclpy.context import Context
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.node import Node
from rclpy.publisher import Publisher
from rclpy.timer import Timer
from std_msgs.msg import Int32, Int32MultiArray, MultiArrayDimension, MultiArrayLayout, String

sign: Callable[[str, str], str] = globals()["sign"]  # provided by the host; signs a report for a topic

# The criteria contain copies of these three constants.
HEARTBEAT_PERIOD_S = 0.1
LOOK_PERIOD_S = 0.5
JOB_S = 0.4

REPEAT_S = 0.1  # the period at which the latest announcement is repeated
PATIENCE_S = 1.0  # a judge that hasn't appeared by then won't appear at all
GRACE_S = 0.3  # a thread that was asked to finish has finished by then


class Watched:
    """Records the unwanted changes that a call of pump makes, such as a new node, rclpy.init, or a reset timer.

    Attributes:
        noted: The unwanted changes since `begin`, in words.
    """

    def __init__(self) -> None:
        self.noted: list[str] = []
        self.watches = False
        self.before: dict[str, list[object]] = {}
        self.periods: dict[Timer, int] = {}
        self.threads: list[threading.Thread] = []

    def note(self, what: str) -> None:
        """Record a change while a call runs, unless it was already recorded."""
        if self.watches and what not in self.noted:
            self.noted.append(what)

    def tells(self, call: Callable[..., Any], what: str) -> Callable[..., Any]:
        """Wrap a function so that each call of it is recorded as `what`."""

        @functools.wraps(call)
        def noted_call(*arguments: Any, **named: Any) -> Any:
            self.note(what)
            return call(*arguments, **named)

        return noted_call

    def begin(self, node: Node) -> None:
        """Start recording changes, because a call of pump with this node is about to start."""
        self.noted = []
        self.before = entities(node)
        self.periods = periods(node)
        self.threads = threading.enumerate()
        self.watches = True

    def end(self, node: Node) -> list[str]:
        """Stop recording after a call, and return the changes that it made."""
        self.watches = False
        after = entities(node)
        for kind, ones in self.before.items():
            for what, some, others in (("left", after[kind], ones), ("gone", ones, after[kind])):
                number = sum(one not in others for one in some)
                if number:
                    self.noted.append(f"{number} {kind}{'s' if number > 1 else ''} {what}")
        job = getattr(node, "at_work", None)
        if job is not None:
            self.noted.append(f"job {job} not finished")
        canceled = sum(is_canceled(timer) for timer in node.timers)
        if canceled:
            self.noted.append(f"{canceled} timer{'s' if canceled > 1 else ''} canceled")
        if any(self.periods.get(timer, period) != period for timer, period in periods(node).items()):
            self.noted.append("period of a timer changed")
        return self.noted

    def left_a_thread(self) -> str:
        """Describe a thread that the call left behind, or return "" if there is none. This may take a moment."""
        new = [one for one in threading.enumerate() if one not in self.threads]
        if any(still_spins(one) for one in new):
            return "a thread still spins"
        return "a thread still runs" if any(still_runs(one) for one in new) else ""


def entities(node: Node) -> dict[str, list[object]]:
    """Return a node's entities and parameters by kind."""
    return {
        "timer": [*node.timers],
        "subscription": [*node.subscriptions],
        "publisher": [*node.publishers],
        "service": [*node.services],
        "client": [*node.clients],
        "guard condition": [*node.guards],
        "parameter": [*node.get_parameters_by_prefix("")],
    }


def periods(node: Node) -> dict[Timer, int]:
    """Return the period (ns) of each timer that wasn't canceled or destroyed."""
    return {timer: timer.timer_period_ns for timer in node.timers if not is_canceled(timer)}


def is_canceled(timer: Timer) -> bool:
    """Return whether a timer was canceled or destroyed."""
    try:
        return bool(timer.is_canceled())
    except Exception:
        return True


def still_spins(thread: threading.Thread) -> bool:
    """Return whether a thread is still spinning after a moment in which it could have finished."""
    if not spins(thread):
        return False
    thread.join(GRACE_S)
    return spins(thread)


def spins(thread: threading.Thread) -> bool:
    """Return whether a thread is currently in one of rclpy's spin functions. A pool's idle thread isn't."""
    frame = sys._current_frames().get(thread.ident or 0)
    while frame is not None:
        code = frame.f_code
        if code.co_filename == rclpy.executors.__file__ and code.co_name.startswith("spin"):
            return True
        frame = frame.f_back
    return False


def still_runs(thread: threading.Thread) -> bool:
    """Return whether a thread is still running after a moment in which it could have finished.

    A pool's idle thread doesn't count as running.
    """
    if waits_for_work(thread):
        return False
    thread.join(GRACE_S)
    return thread.is_alive() and not waits_for_work(thread)


def waits_for_work(thread: threading.Thread) -> bool:
    """Return whether a thread is a pool's idle thread."""
    frame = sys._current_frames().get(thread.ident or 0)
    code = frame.f_code if frame is not None else None
    return code is not None and (code.co_filename, code.co_name) == (
        concurrent.futures.thread.__file__,
        "_worker",
    )


watched = Watched()
rclpy.init = watched.tells(rclpy.init, "rclpy.init called")
Node.__init__ = watched.tells(Node.__init__, "node made")  # type: ignore[method-assign]
Timer.reset = watched.tells(Timer.reset, "timer reset")  # type: ignore[method-assign]

import answer  # type: ignore[import-not-found]  # noqa: E402  # the student's file


class Teller(Node):
    """A node that publishes what it does, and in which call of pump. It can do jobs, which take 0.4 s.

    Topics:
        /robot/job_begun (std_msgs/Int32MultiArray): the call, and the number of a job that begins.
        /robot/job_done (std_msgs/Int32MultiArray): the same two numbers when the job is done.

    Attributes:
        call: The number of the current call, or 0 between calls.
        at_work: The job that the node has begun but not finished, or None if there is none.
    """

    def __init__(self, name: str) -> None:
        super().__init__(name)
        self.call = 0
        self.at_work: int | None = None
        self.job_publisher = self.create_publisher(Int32MultiArray, "/robot/job_begun", 100)
        self.job_done_publisher = self.create_publisher(Int32MultiArray, "/robot/job_done", 100)

    def work(self, job: Int32) -> None:
        """Do a job, which takes 0.4 s."""
        self.at_work = job.data
        self.tell(self.job_publisher, job.data)
        time.sleep(JOB_S)
        self.tell(self.job_done_publisher, job.data)
        self.at_work = None

    def tell(self, publisher: Publisher, number: int) -> None:
        """Publish the call's number and another number, signed."""
        signed = MultiArrayDimension(label=sign(publisher.topic_name, f"{self.call} {number}"))
        publisher.publish(Int32MultiArray(data=[self.call, number], layout=MultiArrayLayout(dim=[signed])))


class Robot(Teller):
    """A robot with two timers, which subscribes to words and to jobs of 0.4 s.

    Topics:
        /robot/heartbeat (std_msgs/Int32MultiArray), 10 Hz, and /robot/look, 2 Hz: the call, and a counter.
        /robot/heard: the call, and each number from /robot/words (std_msgs/Int32).
        /robot/job_begun and /robot/job_done: the call, and each number from /robot/jobs (std_msgs/Int32).
    """

    def __init__(self) -> None:
        super().__init__("robot")
        self.heartbeats = 0
        self.looks = 0
        self.heartbeat_publisher = self.create_publisher(Int32MultiArray, "/robot/heartbeat", 100)
        self.look_publisher = self.create_publisher(Int32MultiArray, "/robot/look", 100)
        self.heard_publisher = self.create_publisher(Int32MultiArray, "/robot/heard", 100)
        self.create_timer(HEARTBEAT_PERIOD_S, self.beat)
        self.create_timer(LOOK_PERIOD_S, self.look_around)
        self.create_subscription(Int32, "/robot/words", self.hear, 100)
        self.create_subscription(Int32, "/robot/jobs", self.work, 100)

    def beat(self) -> None:
        """Publish a heartbeat."""
        self.heartbeats += 1
        self.tell(self.heartbeat_publisher, self.heartbeats)

    def look_around(self) -> None:
        """Publish that the robot has looked around."""
        self.looks += 1
        self.tell(self.look_publisher, self.looks)

    def hear(self, word: Int32) -> None:
        """Publish a received word."""
        self.tell(self.heard_publisher, word.data)


class QuietRobot(Teller):
    """A robot without timers. It's idle until it receives a message.

    Topics:
        /quiet/heard (std_msgs/Int32MultiArray): the call, and each number from /quiet/words (std_msgs/Int32).
    """

    def __init__(self) -> None:
        super().__init__("quiet_robot")
        self.heard_publisher = self.create_publisher(Int32MultiArray, "/quiet/heard", 100)
        self.create_subscription(Int32, "/quiet/words", self.hear, 100)

    def hear(self, word: Int32) -> None:
        """Publish a received word."""
        self.tell(self.heard_publisher, word.data)


class Worker(Teller):
    """A robot that does only jobs.

    Topics:
        /robot/job_begun and /robot/job_done: the call, and each number from /worker/jobs (std_msgs/Int32).
    """

    def __init__(self) -> None:
        super().__init__("worker")
        self.create_subscription(Int32, "/worker/jobs", self.work, 100)


class Driver(Node):
    """Receives orders to call pump, and announces each call's outcome.

    Attributes:
        orders: The orders, by the number of their call.
    """

    def __init__(self, context: Context) -> None:
        super().__init__("driver", context=context)
        self.orders: dict[int, str] = {}
        self.latest = ""
        self.publisher: Publisher | None = None
        self.create_subscription(String, "/driver/go", self.take_order, 100)

    def wait_for_speakers(self, robots: Iterable[Node]) -> None:
        """Wait up to a second until each subscription has a publisher, then create this driver's publishers.

        A node that discovers our publishers may publish right away. If our subscription and that node's publisher
        haven't discovered each other by then, the message is lost.
        """
        ears = [ear for node in (self, *robots) for ear in node.subscriptions]
        end = monotonic() + PATIENCE_S
        while monotonic() < end and not all(ear.get_publisher_count() for ear in ears):
            time.sleep(0.01)
        self.changes = self.create_publisher(String, "/driver/changed", 100)
        self.publisher = self.create_publisher(String, "/driver/pump", 100)

    def take_order(self, message: String) -> None:
        """Store an order. A known order has no effect."""
        number, _, order = message.data.partition(" ")
        self.orders.setdefault(int(number), order)

    def say(self, text: str) -> None:
        """Publish an announcement on /driver/pump."""
        self.latest = text
        self.say_again()

    def say_again(self) -> None:
        """Repeat the latest announcement, because a lost message may arrive only with the next one."""
        if self.latest and self.publisher is not None:
            self.publisher.publish(String(data=sign("/driver/pump", self.latest)))

    def carry_out(self, call: int, node: Teller, seconds: float) -> None:
        """Call `pump` once, and report the call's outcome and the changes that it made."""
        if not callable(getattr(answer, "pump", None)):
            self.say("missing")
            return
        self.say(f"begin {call}")
        node.call = call
        watched.begin(node)
        begin, used, in_line, before = monotonic(), time.process_time(), in_line_s(), taken_s()
        try:
            answer.pump(node, seconds)
        except Exception as error:
            traceback.print_exc()
            news = f"raised {call} {type(error).__name__}: {error}"
        else:
            took, used = monotonic() - begin, time.process_time() - used
            taken = max((after - once for after, once in zip(taken_s(), before, strict=True)), default=0.0)
            news = f"end {call} {took:.3f} {used:.3f} {in_line_s() - in_line:.3f} {taken:.2f}"
        node.call = 0
        for change in watched.end(node):
            self.tell_change(f"{call} {change}")
        self.say(news)
        left = watched.left_a_thread()
        if left:
            self.tell_change(f"{call} {left}")

    def tell_change(self, text: str) -> None:
        """Report a change on /driver/changed."""
        self.changes.publish(String(data=sign("/driver/changed", text)))


def in_line_s() -> float:
    """Return the seconds for which this thread was ready but had no processor, or 0 if that's unknown."""
    try:
        with open("/proc/thread-self/schedstat", encoding="ascii") as file:
            return int(file.read().split()[1]) / 1e9
    except (OSError, IndexError, ValueError):
        return 0.0


def taken_s() -> list[float]:
    """Return the seconds for which a virtual machine's host took each processor away, or [] if that's unknown.

    This is the steal time in proc_stat(5), the eighth number.
    """
    try:
        with open("/proc/stat", encoding="ascii") as file:
            rows = [line.split() for line in file if line.startswith("cpu")]
        return [
            int(row[8]) / os.sysconf("SC_CLK_TCK") for row in rows[1:]
        ]  # the first row is the sum of the others
    except (OSError, IndexError, ValueError):
        return []


def main() -> None:
    """Carry out orders until Ctrl-C."""
    context = Context()
    rclpy.init(context=context)
    if not rclpy.ok():
        rclpy.init()
    driver = Driver(context)
    executor = SingleThreadedExecutor(context=context)
    executor.add_node(driver)
    robots = {robot.get_name(): robot for robot in (Robot(), QuietRobot(), Worker())}
    driver.wait_for_speakers(robots.values())
    done: set[int] = set()
    try:
        while True:
            executor.spin_once(timeout_sec=REPEAT_S)
            driver.say_again()
            for call in sorted(driver.orders.keys() - done):
                name, seconds = driver.orders[call].split()
                driver.carry_out(call, robots[name], float(seconds))
                done.add(call)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()
        rclpy.try_shutdown(context=context)


if __name__ == "__main__":
    main()
