# ---
# exercise: 07_typed_nodes
# title: A report that cannot be misused
# minutes: 30
# difficulty: 3
# kind: static
# clock: simulated
# objectives:
#   - annotate a node so that mypy --strict has nothing to say
#   - give a publisher a type, so that a wrong message is an error before the robot runs
#   - name the allowed words with Literal
#   - guard at run time what hints cannot guard
# out_of_scope:
#   - how the program ends on Ctrl-C (lesson 01 judges that)
#   - subscriptions, services and parameters
#   - True, nan and the numbers of NumPy (exercise 03 judges those)
#   - other type checkers; what is said here holds for pyright as well, in other words
# ---
# %% [markdown]
# # Exercise 07 · A report that cannot be misused
#
# The node below reports battery and status of your humanoid, and it works. From next week on two other teams will call
# it: charging calls `send_battery`, the planner calls `send_status`. They have never met you, and they write their code
# on the train. In a trial last night one of them sent `"full"`, and the dashboard showed 0 %. Make a node of it that
# cannot be misused without a loud word: from mypy, while they type, and from the node itself, when they do not use mypy.
#
# **About 30 minutes · difficulty 3 of 5 · 10 points.** You need lesson [07](../notebooks/07_typed_nodes.ipynb).
#
# ## What to build
#
# Names stay as they are; other code uses them.
#
# | in `RobotReport` | takes | does |
# |---|---|---|
# | `battery_publisher` | has `publish`, for a `Float32` and nothing else | sends on `/robot/battery` |
# | `status_publisher` | has `publish`, for a `String` and nothing else | sends on `/robot/status` |
# | `send_battery(level)` | a number, such as `55.25`, `42` or `0.0` | sends it as a float; anything else raises an error and sends nothing |
# | `send_status(word)` | `"operational"` or `"error"`, letter by letter | sends it; anything else raises an error and sends nothing |
#
# The node goes on reporting by itself: the battery at 1 Hz, the status at 0.5 Hz, 20 % more or less, and without a silence
# of more than one and a half periods.
#
# ## What is judged
#
# mypy reads your program, strictly and with the stubs of this course, and then code that uses your node rightly and
# wrongly. After that your node runs, and is used rightly and wrongly again.
#
# | points | criterion |
# |---:|---|
# | 1 | the node reports as before |
# | 2 | mypy --strict finds nothing in your program |
# | 2 | mypy objects to a message of the wrong type |
# | 1 | mypy objects to a value of the wrong type and to any other word |
# | 1 | every number arrives as that number, `42` and `0.0` too |
# | 2 | at run time a wrong value or message raises an error, and nothing is sent |
# | 1 | at run time a word that is not agreed raises an error, and is not sent |
#
# `# type: ignore` is not heeded, and `Any` may not be written: neither makes the node safer.
#
# **Not part of it:** the end on Ctrl-C, subscriptions, services, parameters. What becomes of `True`, `nan` and the numbers
# of NumPy is up to you; exercise 03 was about those.
# %% [answer]
"""Reports battery and status of a humanoid. Others send through it, too, and cannot get the types wrong unnoticed."""

# [solution]
from typing import Literal, Protocol, TypeVar, get_args

# [starter]
# | # TODO 1: what do you need from typing?
# [end]
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Float32, String

BATTERY_PERIOD_S = 1.0
STATUS_PERIOD_S = 2.0
DRAIN_PERCENT = 0.125
# [solution]

Status = Literal["operational", "error"]
Message = TypeVar("Message")
Taken = TypeVar("Taken", contravariant=True)


class Sends(Protocol[Taken]):
    """Whatever publishes messages of one type, and of no other."""

    def publish(self, msg: Taken) -> None: ...


def make_publisher(node: Node, kind: type[Message], topic: str, depth: int = 10) -> Sends[Message]:
    """A publisher that knows which messages it takes: those of `kind`."""
    return node.create_publisher(kind, topic, depth)


# [starter]
# |
# | # TODO 2: a Protocol with a publish method for one type of message, and a function that makes such a publisher
# | # TODO 3: a type for the two words of the status
# |
# |
# [end]
class RobotReport(Node):
    """Reports the charge in percent and one word on how the robot is.

    Topics:
        /robot/battery (std_msgs/Float32), 1 Hz: charge in percent.
        /robot/status (std_msgs/String), 0.5 Hz: "operational" or "error".
    """

    # [solution]
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
    # [starter]
    # | # TODO 4: hints for every function, and for what others use
    # | def __init__(self):
    # |     super().__init__("robot_report")
    # |     self.level = 100.0
    # |     self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)
    # |     self.status_publisher = self.create_publisher(String, "/robot/status", 10)
    # |     self.create_timer(BATTERY_PERIOD_S, self.report_battery)
    # |     self.create_timer(STATUS_PERIOD_S, self.report_status)
    # |
    # | def report_battery(self):
    # |     """Drain the simulated battery a little and report it."""
    # |     self.level = max(0.0, self.level - DRAIN_PERCENT)
    # |     self.send_battery(self.level)
    # |
    # | def report_status(self):
    # |     """Report whether the robot can work."""
    # |     self.send_status("operational" if self.level > 0.0 else "error")
    # |
    # | def send_battery(self, level):
    # |     """Send a charge in percent."""
    # |     # TODO 5: what is no number raises a TypeError, and nothing is sent; a whole number is sent as a float
    # |     self.battery_publisher.publish(Float32(data=level))
    # |
    # | def send_status(self, word):
    # |     """Send one of the two agreed words."""
    # |     # TODO 6: another word raises a ValueError, and nothing is sent
    # |     self.status_publisher.publish(String(data=word))
    # [end]


# [solution]
def main() -> None:
# [starter]
# | def main():
# [end]
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
# %% [live]
# from workbook.lesson import check_types
#
# %start
# check_types("07_typed_nodes")
# %% [hint]
# Take one net after the other.
#
# - **mypy on your own program.** The cell under *Watch it run* shows all that it says. Without hints it does not even
#   look: begin with `-> None`.
# - **mypy on the others' programs.** They use four names of your node. What does mypy know of each of them?
#   `reveal_type(self.battery_publisher)` in your program tells you.
# - **Run time.** What does `send_battery("full")` do, if nobody runs mypy? And `send_battery(42)`?
#
# What mypy understands: [typing, in the documentation of Python](https://docs.python.org/3/library/typing.html)
# %% [hint]
# - A publisher of rclpy takes every message, as far as mypy can see. So do not say that your attribute is a `Publisher`.
#   Say what you need of it: something with `publish` for one type. That is a `Protocol` with a type variable, as in the
#   lesson.
# - A function with `kind: type[Message]` that returns `Sends[Message]` ties the two together.
# - Two words and no other: `Literal["operational", "error"]`. `get_args` gives you the words at run time.
# - `float` as a hint lets `42` pass, and the message sends 0.0 for it. `float("87.5")` lets a text pass. So ask first
#   (`isinstance`), and convert then.
#
# Nodes, publishers and messages: [Basic concepts](https://docs.ros.org/en/jazzy/Concepts/Basic.html)
# %% [hint]
# ```python
# Status = Literal[___, ___]
# Message = TypeVar("Message")
# Taken = TypeVar("Taken", contravariant=True)
#
#
# class Sends(Protocol[Taken]):
#     def publish(self, msg: ___) -> None: ...
#
#
# def make_publisher(node: Node, kind: type[Message], topic: str) -> Sends[___]:
#     return node.create_publisher(kind, topic, 10)
#
#
# # in RobotReport
# def send_battery(self, level: ___) -> None:
#     if not isinstance(level, (___, ___)):
#         raise TypeError(f"a charge is a number of percent, not {level!r}")
#     self.battery_publisher.publish(Float32(data=___(level)))
# ```
#
# How rclpy itself is typed: [rclpy](https://docs.ros.org/en/jazzy/p/rclpy)
# %% [alternatives]
# ## Other good ways
#
# - **Annotate the attribute and spare the function.** `self.battery_publisher: Sends[Float32] =
#   self.create_publisher(Float32, ...)`. Shorter, but the type stands there twice, and mypy does not notice when the two
#   differ: `create_publisher` takes any class.
# - **A class of your own around the publisher,** `class TypedPublisher(Generic[Message])`, which checks at run time what
#   it is given. More code, and it can do more: convert, count, limit. Right when every node of a project shares it.
# - **Check in one place.** `Float32(data=level, check_fields=True)` lets the message itself refuse a text, and an int
#   as well; so convert first. The error is an AssertionError, and it is gone under `python -O`. Your own `raise` stays.
# - **An Enum for the words,** `class Status(StrEnum)`. It brings the words along at run time. Callers then have to write
#   `Status.ERROR`; a plain `"error"` is an error to mypy. Here the others write plain words.
# - **Newer Python, newer ROS.** From Python 3.12 on one writes `class Sends[M](Protocol)` and spares the type variables.
#   In newer ROS `Publisher` is generic itself, and `Publisher[Float32]` does what `Sends[Float32]` does here.
