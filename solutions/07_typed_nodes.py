# ---
# exercise: 07_typed_nodes
# title: A report that cannot be misused
# minutes: 30
# difficulty: 3
# kind: static
# clock: simulated
# objectives:
#   - annotate a node so that mypy --strict reports nothing
#   - give a publisher a type, so that a wrong message is an error before the robot runs
#   - name the allowed words with Literal
#   - check at run time what hints cannot check
# out_of_scope:
#   - how the program ends on Ctrl-C (lesson 01 judges that)
#   - subscriptions, services and parameters
#   - True, nan and the numbers of NumPy (exercise 03 judges those)
#   - other type checkers; they may accept what mypy reports
# ---
# %% [markdown]
# # Exercise 07 · A report that cannot be misused
#
# The node below reports battery and status of your humanoid, and it works. From next week, two other teams will call
# it: charging calls `send_battery`, the planner calls `send_status`. They do not know you or your code. In a trial last
# night one of them sent `"full"`, and the dashboard showed 0 %. Change the node so that it rejects misuse loudly. mypy
# must report it while they type. When they do not use mypy, the node itself must raise an error.
#
# **About 30 minutes · difficulty 3 of 5 · 10 points.** You need lesson [07](../notebooks/07_typed_nodes.ipynb).
#
# ## What to build
#
# Keep all names; other code uses them.
#
# | in `RobotReport` | accepts | does |
# |---|---|---|
# | `battery_publisher` | has `publish`, for a `Float32` and nothing else | sends on `/robot/battery` |
# | `status_publisher` | has `publish`, for a `String` and nothing else | sends on `/robot/status` |
# | `send_battery(level)` | a number, such as `55.25`, `42` or `0.0` | sends it as a float; anything else raises an error and sends nothing |
# | `send_status(word)` | exactly `"operational"` or `"error"` | sends it; anything else raises an error and sends nothing |
#
# The node still reports by itself: the battery at 1 Hz, the status at 0.5 Hz, each within 20 %. It is never silent for
# more than one and a half periods. What others send changes neither the charge nor the word that it reports.
#
# ## What is judged
#
# mypy checks your program, in strict mode and with the stubs of this course. Then it checks code that uses your node
# correctly, and code that misuses it. After that your node runs, and is used and misused again.
#
# | points | criterion |
# |---:|---|
# | 1 | the node reports as before |
# | 2 | mypy --strict finds nothing in your program |
# | 2 | mypy objects to a message of the wrong type |
# | 1 | mypy objects to a value of the wrong type, to any other word, and to a call without a value |
# | 1 | every number arrives once for each call and as that number, including a whole one, `0.0`, and the same one again |
# | 2 | at run time a wrong value or message raises an error, and nothing is sent |
# | 1 | at run time the two words are sent, also as messages of `status_publisher`; any other word raises an error, and is not sent |
#
# The judge ignores `# type: ignore`, and you may not write `Any`: neither makes the node safer.
#
# **Not part of it:** how the program ends on Ctrl-C, subscriptions, services, parameters. You decide what happens to
# `True`, `nan` and NumPy's numbers (exercise 03 was about those), and to charges below 0 or above 100. The judge creates
# a `RobotReport` itself and never calls your `main()`. It watches for 12 s: if your node's battery is empty later, it
# never sees that.
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
# | # TODO 2: a Protocol with a publish method for one type of message, and a function that creates such a publisher
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
    # | # TODO 4: hints for every function, and for the attributes that others use
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
    # |     # TODO 5: raise a TypeError for what is not a number, and send nothing; send a whole number as a float
    # |     self.battery_publisher.publish(Float32(data=level))
    # |
    # | def send_status(self, word):
    # |     """Send one of the two agreed words."""
    # |     # TODO 6: raise a ValueError for any other word, and send nothing
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
# There are three checks. Take them one at a time.
#
# - **mypy on your own program.** The cell under *Watch it run* shows all its messages. It does not check functions
#   without hints, so begin with `-> None`.
# - **mypy on the others' programs.** They use four names of your node. What does mypy know about each of them?
#   `reveal_type(self.battery_publisher)` in your program tells you.
# - **Run time.** What does `send_battery("full")` do when mypy is not used? And `send_battery(42)`?
#
# What mypy understands: [typing, in the documentation of Python](https://docs.python.org/3/library/typing.html)
# %% [hint]
# - To mypy, a publisher of rclpy accepts every message. So do not annotate your attribute as a `Publisher`. Describe
#   what you need: something with `publish` for one type. That is a `Protocol`, as in the lesson. One for each message is
#   enough.
# - For all messages at once: a function with `kind: type[Message]` that returns `Sends[Message]` (optional notebook
#   07, deeper).
# - For two words and no other, use `Literal["operational", "error"]`. `get_args` returns the words at run time.
# - The hint `float` accepts `42`. The message then sends 0.0, or with the Ubuntu packages may crash the program. And
#   `float("87.5")` accepts a text. So check first (`isinstance`), then convert.
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
# - **Annotate the attribute, without the function.**
#   `self.battery_publisher: Sends[Float32] = self.create_publisher(Float32, ...)`. This is shorter, but the type is
#   written twice, and mypy does not notice when the two differ: `create_publisher` accepts any class.
# - **A class of your own around the publisher,** `class TypedPublisher(Generic[Message])`, which checks at run time
#   what it is given. It is more code, but can do more: convert, count, limit. It is right when every node of a project
#   uses it.
# - **Check in one place.** `Float32(data=level, check_fields=True)` lets the message itself refuse a text, and an int
#   as well, so convert first. The error is an AssertionError, and `python -O` switches the check off. Your own `raise`
#   stays.
# - **An Enum for the words,** `class Status(StrEnum)`. The words are then available at run time. Callers must write
#   `Status.ERROR`; a plain `"error"` is an error to mypy. In this task, callers write plain words.
# - **Newer Python, newer ROS.** From Python 3.12 on you can write `class Sends[M](Protocol)`, without type variables.
#   In newer ROS versions `Publisher` itself is generic, and `Publisher[Float32]` does what `Sends[Float32]` does here.
