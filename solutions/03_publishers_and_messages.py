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
#   - refuse what is no number with an error, instead of sending 0.0
# out_of_scope:
#   - timers and rates; somebody else calls your method
#   - whether a charge makes sense (below 0 or above 100 %); only numbers from 0 to 100 are tried
#   - bools, texts and arrays of NumPy, and bytes
#   - how the program starts and ends
# ---
# %% [markdown]
# # Exercise 03 · A battery report that never lies
#
# Last night the guide robot drove home in the middle of a tour. Its log said 64 % charge, its battery topic said 0.0.
# The charge came from a new driver, as an `int`, and the node put it into a float field. In the morning it happened
# again: the cable was loose, the driver said `None`, and out went 0.0. An empty battery and a bug looked the same.
#
# Write the node once more, so that `/robot/battery` carries only what somebody really measured.
#
# **About 25 minutes · difficulty 2 of 5 · 10 points.** You need lesson
# [03](../notebooks/03_publishers_and_messages.ipynb).
#
# ## What to build
#
# | what | how |
# |---|---|
# | class | `BatteryPublisher`, a `Node` that is made without arguments |
# | topic | `/robot/battery`, type `Float32` of `std_msgs.msg` |
# | method | `publish_level(level)`: sends one message, before it returns, with the charge in percent |
#
# `level` is whatever the driver delivers:
#
# | given | for example | your method |
# |---|---|---|
# | a float | `87.25`, `0.1`, and `0.0` for an empty battery | sends it |
# | another number, of Python's or NumPy's types | `64`, `np.float32(12.5)`, `np.float64(33.25)`, `np.int64(7)` | sends that number as a float |
# | no number | `None`, `'full'`, `[50.0]` | raises an error and sends nothing |
# | what only looks like one | `True`, and `'50'`: texts stay texts | raises an error and sends nothing |
# | no measurement | `nan`, `inf`, `-inf`, also in one of NumPy's types | raises an error and sends nothing |
#
# Each call counts, whatever came before it: a number that was sent already is sent again, and after an error the next
# number goes out as usual.
#
# Which error you raise is up to you. `TypeError` for a wrong type and `ValueError` for a wrong value are usual.
#
# ## What is judged
#
# Your file is imported by a driver, which makes one `BatteryPublisher` and calls `publish_level` with 35 values, one
# after the other: some of those above, others of the same kinds, and some more than once. It notes whether the call came
# back or raised an error. We listen to the topic, and compare. As on any robot out of the box, ROS checks no field.
#
# | points | criterion |
# |---:|---|
# | 1 | `/robot/battery` carries `Float32` |
# | 2 | floats arrive within 0.00001, each of them once |
# | 1 | a `0.0` that is meant arrives |
# | 2 | other numbers arrive as their number, within 0.00001 |
# | 1 | `None`, words, a list and a tuple are refused with an error |
# | 1 | bools and texts such as `'50'` are refused with an error |
# | 1 | `nan`, `inf` and `-inf` are refused with an error |
# | 1 | no `0.0` on the wire that nobody meant |
#
# **Not part of it:** timers, charges below 0 or above 100, NumPy's bools, texts and arrays, bytes, and how a program starts
# and ends. There is no `main()`: somebody else makes your node, and spins it.
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
        # | # TODO 2: raise an error if level is no number, no finite one, or a bool
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
# Write the shortest method that could work: make a `Float32`, publish it. Then start it and look at the table. Which
# lines say something else than you gave? Those are two problems, not one:
#
# - a **number** of another type than `float` is lost on its way,
# - **no number** at all is sent as if it were one.
#
# The first wants a conversion, the second a question that you ask *before* the conversion.
#
# Field types and their Python types: [About interfaces](https://docs.ros.org/en/jazzy/Concepts/Basic/About-Interfaces.html)
# %% [hint]
# - `float(64)`, `float(np.float32(12.5))` and `float(np.int64(7))` are Python floats with the right value.
# - But `float(True)` is 1.0, `float("50")` is 50.0 and `float("nan")` is nan. So `float()` alone is no test.
# - `numbers.Real` of the standard library stands for "a real number of whatever type", NumPy's included:
#   `isinstance(level, Real)`. A text, a list and `None` are none. Alas, a `bool` is one: ask for it first.
# - `math.isfinite(level)` is False for nan and inf.
# - An error is made with `raise TypeError("...")`. Do not catch it in your method: it is meant for the one who called.
# - `if not level` is no test for a missing value. It is also true for `0.0`.
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
# - **Name the types that you take.** `isinstance(level, (int, float, np.integer, np.floating))` says in one line what is
#   welcome, and needs NumPy. `numbers.Real` needs nothing and takes fractions as well. The bool has to be refused by
#   hand in both.
# - **`functools.singledispatchmethod`.** One method per type, and one for all the rest that raises. Pleasant when types
#   are really treated differently. Here all of them are treated alike.
# - **Ask for forgiveness.** `charge = float(level)` in a `try`, and only `str` and `bool` refused by hand. Shorter, but
#   you list what you do not want, and will forget something: `float()` reads bytes, too.
# - **`Float32(data=float(level), check_fields=True)`.** Field checks for this one message, wherever the program runs. They
#   catch a wrong type and a number too large for 32 bits. They do not mind nan, and after `float()` nothing else is left
#   to find.
# - **`ROS_PYTHON_CHECK_FIELDS=1` for the whole robot.** Good as a second net, and cheap. As the only net it refuses honest
#   ints, and it is gone on a robot where nobody set it, or where Python runs with `-O`.
# - **Send `nan` for "not known".** `sensor_msgs/msg/BatteryState` does so, and says it in its definition. Without such a
#   rule a listener that asks `level < 20` gets False, and believes that all is well.
