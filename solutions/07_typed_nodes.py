# ---
# exercise: 07_typed_nodes
# title: A report that can't be misused
# minutes: 30
# difficulty: 3
# kind: static
# clock: simulated
# objectives:
#   - annotating a node so that mypy --strict reports no errors
#   - giving a publisher a type so that mypy catches messages of the wrong type before the robot runs
#   - listing the allowed words with Literal
#   - checking values at run time, when type hints have no effect
# out_of_scope:
#   - how the program ends on Ctrl-C (lesson 01 judges that)
#   - subscriptions, services and parameters
#   - True, nan, and NumPy's numbers (exercise 03 judges those)
#   - other type checkers; they may accept code that mypy rejects
# ---
# %% [markdown]
# # Exercise 07 · A report that can't be misused
#
# The node below reports your humanoid's battery charge and status, and it works. Starting next week, two other teams
# will call its methods: the charging team calls `send_battery`, and the planning team calls `send_status`. They don't
# know you or your code. In a trial run, one of the teams sent `"full"`, and the dashboard showed 0 %. Change the node
# so that misuse can't go unnoticed. If the other teams check their code with mypy, mypy must report the misuse. If they
# don't, the node itself must raise an exception.
#
# **About 30 minutes · difficulty 3 of 5 · 10 points.** This exercise builds on lesson
# [07](../notebooks/07_typed_nodes.ipynb).
#
# ## What to build
#
# Don't rename anything, because other code relies on the existing names.
#
# | in `RobotReport` | accepts | does |
# |---|---|---|
# | `battery_publisher.publish` | a `Float32` message and nothing else | publishes it on `/robot/battery` |
# | `status_publisher.publish` | a `String` message and nothing else | publishes it on `/robot/status` |
# | `send_battery(level)` | a number, such as `55.25`, `42`, or `0.0` | publishes the number as a float; for anything else, raises an exception and publishes nothing |
# | `send_status(word)` | exactly `"operational"` or `"error"` | publishes the word; for anything else, raises an exception and publishes nothing |
#
# The node must still publish its own reports: the battery at 1 Hz and the status at 0.5 Hz. Each rate may be off by up
# to {{rates.RATE_TOLERANCE %}}, and no gap between consecutive reports may be longer than one and a half periods. Calls
# from other teams must not change the charge or the status that the node itself reports.
#
# ## What is judged
#
# First, mypy checks your program in strict mode, with this course's stubs. Then it checks code that uses your node
# correctly, and code that misuses it. After that, the judge runs your node and calls its methods, with both valid and
# invalid arguments.
#
# | points | criterion |
# |---:|---|
# | 1 | the node publishes its own reports as before |
# | 2 | `mypy --strict` reports no errors in your program |
# | 2 | mypy reports an error if a publisher is passed a message of the wrong type |
# | 1 | mypy reports an error if `send_battery` or `send_status` is called with no value, or with a value of the wrong type. It also reports an error if `send_status` is passed any word other than the two allowed words |
# | 1 | each number passed to `send_battery`, or in a message passed to `battery_publisher.publish`, is published exactly once. That includes whole numbers, `0.0`, and numbers that an earlier call has already published |
# | 2 | at run time, passing a value or a message of the wrong type raises an exception and publishes nothing |
# | 1 | at run time, `send_status` and `status_publisher` publish both allowed words; for any other word, `send_status` raises an exception and publishes nothing |
#
# The judge ignores `# type: ignore` comments, and you may not use `Any`, because both would just hide errors from mypy.
#
# **Not judged:**
#
# - subscriptions, services, parameters, and how the program ends on Ctrl-C
# - `True`, `nan`, and NumPy numbers (exercise 03 covered those), and charges below 0 or above 100. How you
#   handle these values is up to you.
# - your `main()`, because the judge creates a `RobotReport` itself
# - anything that the node reports after the first {{plan.simulated_s}} s, such as an empty battery, because the judge
#   stops watching then
# %% [answer]
"""Report a humanoid's battery and status. Other code publishes through this node, too, so it checks types."""

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
    """An object that publishes messages of one type and no others."""

    def publish(self, msg: Taken) -> None: ...


def make_publisher(node: Node, kind: type[Message], topic: str, depth: int = 10) -> Sends[Message]:
    """Create a publisher that, to mypy, accepts only messages of type `kind`."""
    return node.create_publisher(kind, topic, depth)


# [starter]
# |
# | # TODO 2: a Protocol with a publish method for one message type, and a function that creates such a publisher
# | # TODO 3: a type for the two words of the status
# |
# |
# [end]
class RobotReport(Node):
    """Reports the battery's charge in percent and the robot's status as one word.

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
            TypeError: `level` isn't a number.
        """
        if not isinstance(level, (int, float)):
            raise TypeError(f"a charge is a number of percent, not {level!r}")
        self.battery_publisher.publish(Float32(data=float(level)))

    def send_status(self, word: Status) -> None:
        """Send one of the two agreed words.

        Raises:
            ValueError: `word` is any other word.
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
    # |     # TODO 5: raise a TypeError for anything but a number, and send nothing; send a whole number as a float
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
    """Run the node until Ctrl-C or SIGTERM, then exit with code 0."""
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
# - **mypy on your program.** The cell under *Watch it run* shows all of mypy's messages. Without hints, mypy doesn't
#   check a function's body, so begin with `-> None`.
# - **mypy on the other teams' programs.** They use four of your node's names. What does mypy know about each of them?
#   Put `reveal_type(self.battery_publisher)` into your program, and mypy tells you.
# - **Run time.** What does `send_battery("full")` do if the caller doesn't use mypy? And `send_battery(42)`?
#
# The types that mypy understands: [typing, in Python's documentation](https://docs.python.org/3/library/typing.html)
# %% [hint]
# - To mypy, an rclpy publisher accepts every message. So don't annotate your attribute as a `Publisher`. Describe what
#   you need: an object with a `publish` method for one type. That's a `Protocol`, as in the lesson. One `Protocol`
#   for each message type is enough.
# - To cover all message types with one function, let it take `kind: type[Message]` and return `Sends[Message]`
#   (see the optional notebook 07, deeper).
# - To allow two words and no others, use `Literal["operational", "error"]`. `get_args` returns the words at run time.
# - The hint `float` also accepts `42`. Without a conversion, the message would contain 0.0, or, with the Ubuntu
#   packages, the program might crash. But `float(level)` also accepts the string `"87.5"`. So check first
#   (`isinstance`), then convert.
#
# Nodes, publishers, and messages: [Basic concepts](https://docs.ros.org/en/jazzy/Concepts/Basic.html)
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
# - **Annotate the attribute, without a function.** Write `self.battery_publisher: Sends[Float32] =
#   self.create_publisher(Float32, ...)`. This is shorter, but you write the type twice. mypy doesn't notice when the
#   two differ, because `create_publisher` accepts any class.
# - **Write your own class around the publisher,** such as `class TypedPublisher(Generic[Message])`, and let it check
#   its argument at run time. It's more code, but it can do more: convert, count, or limit. It's worth the effort when
#   all nodes of a project use it.
# - **Check in one place.** With `Float32(data=level, check_fields=True)`, the message itself rejects a string. It also
#   rejects an int, so convert first. The exception is an AssertionError, and `python -O` switches the check off. Your
#   own `raise` always works.
# - **Use an Enum for the words,** `class Status(StrEnum)`. The words are then available at run time, too. Callers must
#   write `Status.ERROR`, because mypy rejects a plain `"error"`. In this task, callers write plain words.
# - **Newer Python, newer ROS.** In Python 3.12 and later, you can write `class Sends[M](Protocol)`, without type
#   variables. In newer ROS versions, `Publisher` itself is generic, and `Publisher[Float32]` does the job of
#   `Sends[Float32]`.
