# ---
# exercise: 03_publishers_and_messages
# title: A battery report that never lies
# minutes: 25
# difficulty: 2
# kind: function
# clock: wall
# objectives:
#   - create a publisher, fill a message and publish it
#   - send any number so that it arrives as that number
#   - refuse what is not a number with an error, instead of sending 0.0
# out_of_scope:
#   - timers and rates; other code calls your method
#   - whether a charge makes sense (below 0 or above 100 %); only numbers from 0 to 100 are tried
#   - bools, texts and arrays of NumPy, and bytes
#   - how the program starts and ends
# ---
# %% [markdown]
# # Exercise 03 · A battery report that never lies
#
# Last night the guide robot drove home in the middle of a tour. Its log said 64 % charge, but its battery topic said
# 0.0. The charge came from a new driver as an `int`, and the node put it into a float field. That can crash the node, as
# with the Ubuntu packages of ROS, or send 0.0, as in this build. In the morning it happened again: the cable was loose, the
# driver returned `None`, and the node sent 0.0. An empty battery and a bug looked the same.
#
# Write the node again, so that `/robot/battery` carries only values that were really measured.
#
# **About 25 minutes · difficulty 2 of 5 · 10 points.** You need lesson
# [03](../notebooks/03_publishers_and_messages.ipynb).
#
# ## What to build
#
# | what | how |
# |---|---|
# | class | `BatteryPublisher`, a `Node` that is created without arguments |
# | topic | `/robot/battery`, type `Float32` of `std_msgs.msg` |
# | method | `publish_level(level)`: sends one message, before it returns, with the charge in percent |
#
# `level` is what the driver returns:
#
# | given | for example | your method |
# |---|---|---|
# | a float | `87.25`, `0.1`, and `0.0` for an empty battery | sends it |
# | another number, of Python's or NumPy's types | `64`, `np.float32(12.5)`, `np.float64(33.25)`, `np.int64(7)` | sends that number as a float |
# | not a number | `None`, `'full'`, `[50.0]` | raises an error and sends nothing |
# | what only looks like a number | `True`, and `'50'`, which is a text | raises an error and sends nothing |
# | no measurement | `nan`, `inf`, `-inf`, also in one of NumPy's types | raises an error and sends nothing |
#
# Each call is independent of earlier calls. Send a number again even if it was sent before, and after an error send the
# next number as usual. A call may also come right after another one, a few milliseconds later.
#
# You choose which error to raise. `TypeError` for a wrong type and `ValueError` for a wrong value are usual.
#
# ## What is judged
#
# A driver imports your file and creates one `BatteryPublisher`. It calls `publish_level` with 40 values, one after
# another: some of those above, others of the same kinds, and some more than once. It notes whether each call returned
# or raised an error, and whether anything was sent before the first call. The judge compares this with the messages on
# the topic. Field checks are off, as they are by default in ROS.
#
# | points | criterion |
# |---:|---|
# | 1 | `/robot/battery` carries `Float32` |
# | 2 | floats arrive within 0.00001, each of them once |
# | 1 | a `0.0` that was really given arrives |
# | 2 | other numbers arrive as the same number, within 0.00001 |
# | 1 | `None`, words, a list and a tuple are refused with an error |
# | 1 | bools and texts such as `'50'` are refused with an error |
# | 1 | `nan`, `inf` and `-inf` are refused with an error |
# | 1 | no `0.0` is sent by mistake |
#
# **Not part of it:** timers, charges below 0 or above 100, other kinds of numbers (`Decimal`, `Fraction`, `complex`),
# NumPy's bools, texts and arrays, and bytes. How a program starts and ends is not part of it, either. There is no
# `main()`: other code creates and spins your node.
# %% [answer]
"""A node that reports the charge of the battery, and nothing but the charge."""

# [solution]
import math
from numbers import Real

# [end]
from rclpy.node import Node
from std_msgs.msg import Float32


class BatteryPublisher(Node):
    """Reports the charge of the battery whenever it is told one.

    Topics:
        /robot/battery (std_msgs/Float32): charge in percent.
    """

    def __init__(self) -> None:
        super().__init__("battery_publisher")
        # [solution]
        self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)
        # [starter]
        # | # TODO 1: create a publisher for Float32 messages on /robot/battery
        # [end]

    def publish_level(self, level: object) -> None:
        """Send the charge in percent.

        Raises:
            TypeError: `level` is no number.
            ValueError: `level` is nan or infinite.
        """
        # [solution]
        if isinstance(level, bool) or not isinstance(level, Real):
            raise TypeError(f"a charge is a number, not {level!r}")
        if not math.isfinite(level):
            raise ValueError(f"a charge is a finite number, not {level}")
        self.battery_publisher.publish(Float32(data=float(level)))
        # [starter]
        # | # TODO 2: raise an error if level is not a number, not finite, or a bool
        # | # TODO 3: make a Float32 message that holds level as a Python float, and publish it
        # [end]
# %% [live]
# from lesson_nodes.level_desk import LevelDesk
# from workbook.lesson import fresh, init, run
#
# VALUES = ["87.25", "64", "np.float32(12.5)", "0.0", "None", "True", "nan"]  # try your own
#
# %start
# init()
# desk = fresh(LevelDesk, VALUES)  # asks for one call after the other, and writes down what arrives
# try:
#     await run(desk, seconds=10, until=lambda: desk.done)
# except TimeoutError:
#     print("Not all of the calls came back.")
# print(desk.table())
# %% [hint]
# Write the shortest method that could work: make a `Float32`, publish it. Then start it and look at the table. In
# which rows is the value that arrives not the value that you gave? You will see two different problems:
#
# - a **number** of a type other than `float` arrives as 0.0,
# - a value that is **not a number** is sent as if it were one.
#
# The first problem needs a conversion, the second a check *before* the conversion.
#
# Field types and their Python types: [About interfaces](https://docs.ros.org/en/jazzy/Concepts/Basic/About-Interfaces.html)
# %% [hint]
# - `float(64)`, `float(np.float32(12.5))` and `float(np.int64(7))` are Python floats with the right value.
# - But `float(True)` is 1.0, `float("50")` is 50.0 and `float("nan")` is nan. So `float()` alone does not check
#   anything.
# - `numbers.Real` in the standard library means "a real number of any type", including NumPy's:
#   `isinstance(level, Real)`. It is False for a text, a list and `None`. But it is True for a `bool`, so check for
#   `bool` first.
# - `math.isfinite(level)` is False for nan and inf.
# - Raise an error with `raise TypeError("...")`. Do not catch it in your method: it is meant for the caller.
# - `if not level` is not a test for a missing value. It is also true for `0.0`.
#
# What a node and its publishers offer: [rclpy](https://docs.ros.org/en/jazzy/p/rclpy)
# %% [hint]
# The method with gaps:
#
# ```python
# # in __init__
# self.battery_publisher = self.create_publisher(___, "/robot/battery", ___)
#
# def publish_level(self, level: object) -> None:
#     if isinstance(level, ___) or not isinstance(level, ___):
#         raise TypeError(f"a charge is a number, not {level!r}")
#     if not math.___(level):
#         raise ValueError(f"a charge is a finite number, not {level}")
#     self.battery_publisher.publish(Float32(data=___(level)))
# ```
#
# A publisher, step by step: [Writing a simple publisher and
# subscriber](https://docs.ros.org/en/jazzy/Tutorials/Beginner-Client-Libraries/Writing-A-Simple-Py-Publisher-And-Subscriber.html)
# %% [alternatives]
# ## Other good ways
#
# - **Name the types that you take.** `isinstance(level, (int, float, np.integer, np.floating))` shows in one line what
#   is accepted, but needs NumPy. `numbers.Real` needs no import of NumPy and accepts fractions as well. In both cases
#   you must refuse a bool yourself.
# - **`functools.singledispatchmethod`.** You write one method per type, and one for everything else, which raises. This
#   is useful when types are treated differently. Here all of them are treated the same.
# - **Ask for forgiveness.** Write `charge = float(level)` in a `try`, and refuse only `str` and `bool` yourself. This
#   is shorter, but you list what you do not want, and will forget something: `float()` reads bytes, too.
# - **`Float32(data=float(level), check_fields=True)`.** This turns on field checks for one message, wherever the
#   program runs. They catch a wrong type and a number too large for 32 bits. They accept nan, and after `float()` they
#   have nothing left to find.
# - **`ROS_PYTHON_CHECK_FIELDS=1` for the whole robot.** This is a good and cheap second check. As the only check it
#   refuses valid ints. It does nothing on a robot where it is not set, or where Python runs with `-O`.
# - **Send `nan` for "not known".** `sensor_msgs/msg/BatteryState` does this, and its definition says so. Without such a
#   rule, a subscriber that tests `level < 20` gets False, and believes that all is well.
