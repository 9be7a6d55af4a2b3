"""Calls `pump` of an answer, each time that somebody says so on /driver/go, and announces begin and end of each call.

    /driver/go (std_msgs/String), heard: "1 robot 1.5" means that call 1 is pump(robot, 1.5). An order may come again.
    /driver/pump (std_msgs/String), said: "begin 1", then "end 1 1.501 0.020 0.001 0.03", or "raised 1 TypeError: ...",
        or "missing" if the answer has no such function. The call took 1.501 s. In this time the program used a
        processor for 0.02 s, the thread that called waited for one for 0.001 s, and the host of the machine took one
        away for 0.03 s. The last announcement is made again and again until something new happens.
    /driver/changed (std_msgs/String), said: what a call has changed and should not have: "1 timer left", for example.

All of this is signed, and so is what the robots tell, in the label of its first dimension.

What the robots do, they tell with the number of the call in which they did it, 0 between the calls. So it does not
matter when a message arrives on a busy machine. The driver speaks from a context of its own: it can still tell what
happened when an answer shuts ROS down.
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

sign: Callable[[str, str], str] = globals()["sign"]  # the host has put it here: it signs a report for a topic

# The criteria know these three.
HEARTBEAT_PERIOD_S = 0.1
LOOK_PERIOD_S = 0.5
JOB_S = 0.4

REPEAT_S = 0.1  # how often the latest announcement is made again
PATIENCE_S = 1.0  # a judge that is not there by then will not come
GRACE_S = 0.3  # a thread that was told to end has ended by then


class Watched:
    """Notes what a call of pump changes: who calls rclpy.init, makes a node, or starts a timer anew.

    Attributes:
        noted: What was done and should not have been, in words, since `begin`.
    """

    def __init__(self) -> None:
        self.noted: list[str] = []
        self.watches = False
        self.before: dict[str, list[object]] = {}
        self.periods: dict[Timer, int] = {}
        self.threads: list[threading.Thread] = []

    def note(self, what: str) -> None:
        """Note something once, while a call runs."""
        if self.watches and what not in self.noted:
            self.noted.append(what)

    def tells(self, call: Callable[..., Any], what: str) -> Callable[..., Any]:
        """The same function, but each call of it is noted."""

        @functools.wraps(call)
        def told(*arguments: Any, **named: Any) -> Any:
            self.note(what)
            return call(*arguments, **named)

        return told

    def begin(self, node: Node) -> None:
        """A call of pump begins, with this node."""
        self.noted = []
        self.before = entities(node)
        self.periods = periods(node)
        self.threads = threading.enumerate()
        self.watches = True

    def end(self, node: Node) -> list[str]:
        """The call has ended: what it has changed."""
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
        """What a thread does that the call has left behind, in words; empty if there is none. It may take a moment."""
        new = [one for one in threading.enumerate() if one not in self.threads]
        if any(still_spins(one) for one in new):
            return "a thread still spins"
        return "a thread still runs" if any(still_runs(one) for one in new) else ""


def entities(node: Node) -> dict[str, list[object]]:
    """What a node has."""
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
    """The period (ns) of each timer that still has one."""
    return {timer: timer.timer_period_ns for timer in node.timers if not is_canceled(timer)}


def is_canceled(timer: Timer) -> bool:
    """Whether a timer was canceled, or destroyed."""
    try:
        return bool(timer.is_canceled())
    except Exception:
        return True


def still_spins(thread: threading.Thread) -> bool:
    """Whether a thread goes on in a spin of rclpy: one that was told to end has a moment to do so."""
    if not spins(thread):
        return False
    thread.join(GRACE_S)
    return spins(thread)


def spins(thread: threading.Thread) -> bool:
    """Whether a thread is in a spin of rclpy now. A pool's thread that waits for work is not."""
    frame = sys._current_frames().get(thread.ident or 0)
    while frame is not None:
        code = frame.f_code
        if code.co_filename == rclpy.executors.__file__ and code.co_name.startswith("spin"):
            return True
        frame = frame.f_back
    return False


def still_runs(thread: threading.Thread) -> bool:
    """Whether a thread goes on with anything: one that was told to end has a moment to do so."""
    if waits_for_work(thread):
        return False
    thread.join(GRACE_S)
    return thread.is_alive() and not waits_for_work(thread)


def waits_for_work(thread: threading.Thread) -> bool:
    """Whether this is a pool's thread that has nothing to do."""
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
    """A node that tells what it does, and in which call of pump. It does jobs of 0.4 s.

    Topics:
        /robot/job_begun (std_msgs/Int32MultiArray): the call; the number of a job. /robot/job_done: when it ends.

    Attributes:
        call: The number of the call that runs now; 0 if none does.
        at_work: The job that was begun and is not finished; None if there is none.
    """

    def __init__(self, name: str) -> None:
        super().__init__(name)
        self.call = 0
        self.at_work: int | None = None
        self.job_publisher = self.create_publisher(Int32MultiArray, "/robot/job_begun", 100)
        self.job_done_publisher = self.create_publisher(Int32MultiArray, "/robot/job_done", 100)

    def work(self, job: Int32) -> None:
        """Do a job that takes its time."""
        self.at_work = job.data
        self.tell(self.job_publisher, job.data)
        time.sleep(JOB_S)
        self.tell(self.job_done_publisher, job.data)
        self.at_work = None

    def tell(self, publisher: Publisher, number: int) -> None:
        """Publish the number of the call and another number."""
        signed = MultiArrayDimension(label=sign(publisher.topic_name, f"{self.call} {number}"))
        publisher.publish(Int32MultiArray(data=[self.call, number], layout=MultiArrayLayout(dim=[signed])))


class Robot(Teller):
    """A robot with two timers that listens to words, and to jobs of 0.4 s.

    Topics:
        /robot/heartbeat (std_msgs/Int32MultiArray), 10 Hz, and /robot/look, 2 Hz: the call; how many there were.
        /robot/heard: the call; each number from /robot/words (std_msgs/Int32).
        /robot/job_begun and /robot/job_done: each number from /robot/jobs (std_msgs/Int32).
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
        """Tell that the robot lives."""
        self.heartbeats += 1
        self.tell(self.heartbeat_publisher, self.heartbeats)

    def look_around(self) -> None:
        """Tell that the robot has looked around."""
        self.looks += 1
        self.tell(self.look_publisher, self.looks)

    def hear(self, word: Int32) -> None:
        """Repeat a word."""
        self.tell(self.heard_publisher, word.data)


class QuietRobot(Teller):
    """A robot without timers: as long as nobody talks to it, it has nothing to do.

    Topics:
        /quiet/heard (std_msgs/Int32MultiArray): the call; each number from /quiet/words (std_msgs/Int32).
    """

    def __init__(self) -> None:
        super().__init__("quiet_robot")
        self.heard_publisher = self.create_publisher(Int32MultiArray, "/quiet/heard", 100)
        self.create_subscription(Int32, "/quiet/words", self.hear, 100)

    def hear(self, word: Int32) -> None:
        """Repeat a word."""
        self.tell(self.heard_publisher, word.data)


class Worker(Teller):
    """A robot that does jobs, and nothing else.

    Topics:
        /robot/job_begun and /robot/job_done: each number from /worker/jobs (std_msgs/Int32).
    """

    def __init__(self) -> None:
        super().__init__("worker")
        self.create_subscription(Int32, "/worker/jobs", self.work, 100)


class Driver(Node):
    """Hears what is to be pumped, and says what came of it.

    Attributes:
        orders: What was ordered, by the number of the call.
    """

    def __init__(self, context: Context) -> None:
        super().__init__("driver", context=context)
        self.orders: dict[int, str] = {}
        self.latest = ""
        self.publisher: Publisher | None = None
        self.create_subscription(String, "/driver/go", self.take_order, 100)

    def wait_for_speakers(self, robots: Iterable[Node]) -> None:
        """Wait until somebody is there to speak to all that listen, but not for long; then announce that we are there.

        Who hears our first word may speak at once, and what is said before both ends know each other is lost.
        """
        ears = [ear for node in (self, *robots) for ear in node.subscriptions]
        end = monotonic() + PATIENCE_S
        while monotonic() < end and not all(ear.get_publisher_count() for ear in ears):
            time.sleep(0.01)
        self.changes = self.create_publisher(String, "/driver/changed", 100)
        self.publisher = self.create_publisher(String, "/driver/pump", 100)

    def take_order(self, message: String) -> None:
        """Note an order; one that is known already changes nothing."""
        number, _, order = message.data.partition(" ")
        self.orders.setdefault(int(number), order)

    def say(self, text: str) -> None:
        """Announce something on /driver/pump."""
        self.latest = text
        self.say_again()

    def say_again(self) -> None:
        """Announce the latest once more: on a busy machine a message may get lost until the next one comes."""
        if self.latest and self.publisher is not None:
            self.publisher.publish(String(data=sign("/driver/pump", self.latest)))

    def carry_out(self, call: int, node: Teller, seconds: float) -> None:
        """Call `pump` once."""
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
        """Say on /driver/changed what a call has changed, or left."""
        self.changes.publish(String(data=sign("/driver/changed", text)))


def in_line_s() -> float:
    """How long (s) this thread was ready to run and got no processor; 0 where the system does not tell."""
    try:
        with open("/proc/thread-self/schedstat", encoding="ascii") as file:
            return int(file.read().split()[1]) / 1e9
    except (OSError, IndexError, ValueError):
        return 0.0


def taken_s() -> list[float]:
    """How long (s) the host of a virtual machine has taken each processor away so far; [] if the system does not tell.

    Steal time of proc_stat(5), the eighth number.
    """
    try:
        with open("/proc/stat", encoding="ascii") as file:
            rows = [line.split() for line in file if line.startswith("cpu")]
        return [
            int(row[8]) / os.sysconf("SC_CLK_TCK") for row in rows[1:]
        ]  # the first one is the sum of the others
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
