# ---
# exercise: 03_publishers_and_messages
# title: A battery report that never lies
# minutes: 25
# difficulty: 2
# kind: function
# clock: wall
# objectives:
#   - creating a publisher, and filling in and publishing a message
#   - publishing any number without changing its value
#   - raising an error for any value that isn't a number, instead of publishing 0.0
# out_of_scope:
#   - timers and rates; other code calls your method
#   - whether a charge makes sense (below 0 or above 100 %); only numbers from 0 to 100 are tried
#   - NumPy's bools, strings, and arrays, and bytes
#   - how the program starts and ends
# ---
# %% [markdown]
# # Exercise 03 · A battery report that never lies
#
# Last night, the guide robot drove home in the middle of a tour. Its log reported a charge of 64%, but its battery
# topic reported 0.0. The battery's new driver software had returned the charge as an `int`, and the node had put that
# `int` into a float field. With this course's ROS build, a node that does this publishes 0.0; with the ROS packages for
# Ubuntu, it may crash. This morning, a cable came loose, so the driver returned `None`, and the node published 0.0
# again. As a result, the staff couldn't tell a bug from an empty battery.
#
# Rewrite the node so that `/robot/battery` carries only values that were actually measured.
#
# **About 25 minutes · difficulty 2 of 5 · 10 points.** This exercise builds on lesson
# [03](../notebooks/03_publishers_and_messages.ipynb).
#
# ## What to build
#
# | part | description |
# |---|---|
# | class | `BatteryPublisher`, a subclass of `Node`; other code creates it with `BatteryPublisher()` |
# | topic | `/robot/battery`, type `Float32` from `std_msgs.msg` |
# | method | `publish_level(level)`, which publishes the charge, in percent, as one message and only then returns |
#
# `level` is the value that the battery driver returned:
#
# | `level` is | for example | your method |
# |---|---|---|
# | a float | `87.25`, `0.1`, or `0.0` for an empty battery | publishes it |
# | any other Python or NumPy number | `64`, `np.float32(12.5)`, `np.float64(33.25)`, `np.int64(7)` | publishes that number as a float |
# | not a number | `None`, `'full'`, `[50.0]` | raises an error and publishes nothing |
# | a value that only looks like a number | `True`, or the string `'50'` | raises an error and publishes nothing |
# | a float that can't be a measurement | `nan`, `inf`, or `-inf`, from Python or NumPy | raises an error and publishes nothing |
#
# Each call is independent of earlier calls. Publish a number even if you've published it before. After an error,
# publish the next number as usual. Calls may come only a few milliseconds apart.
#
# You choose which error to raise. The usual choices are `TypeError` for a wrong type and `ValueError` for a wrong
# value.
#
# ## What is judged
#
# A test program imports your file and creates one `BatteryPublisher`. (In the feedback, *the driver* means this
# test program, not the battery driver.) The test program calls `publish_level` with {{COUNT}} values, one after
# another. The values are similar to those above, and some occur more than once. For each call, the test program records
# whether the call returned or raised an error. It also records whether anything was published before the first call.
# The judge compares these records with the messages on the topic. rclpy's type checks are off by default, and the test
# leaves them off, so rclpy won't catch a wrong field type for you.
#
# | points | criterion |
# |---:|---|
# | 1 | `/robot/battery` carries `Float32` messages |
# | 2 | each float arrives exactly once, accurate to within {{TOLERANCE}} |
# | 1 | a measured `0.0` arrives |
# | 2 | any other number arrives exactly once, accurate to within {{TOLERANCE}} |
# | 1 | for `None`, a word, a list, or a tuple, the method raises an error and publishes nothing |
# | 1 | for a bool or a string such as `'50'`, the method raises an error and publishes nothing |
# | 1 | for `nan`, `inf`, or `-inf`, the method raises an error and publishes nothing |
# | 1 | no `0.0` is published by mistake |
#
# **Not judged:** timers, charges below 0 or above 100, bytes, other kinds of numbers (`Decimal`, `Fraction`,
# `complex`), and NumPy's bools, strings, and arrays. The program's startup and shutdown aren't judged, either.
# There's no `main()`, because other code creates and spins your node.
# %% [answer]
"""Publish a battery's charge, and refuse every value that isn't a number."""

# [solution]
import math
from numbers import Real

# [end]
from rclpy.node import Node
from std_msgs.msg import Float32


class BatteryPublisher(Node):
    """Publishes the battery's charge whenever `publish_level` is called.

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
        """Publish a charge in percent.

        Raises:
            TypeError: `level` is a bool, or isn't a number.
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
        # | # TODO 3: create a Float32 message that contains level as a Python float, and publish it
        # [end]
# %% [live]
# from lesson_nodes.level_desk import LevelDesk
# from workbook.lesson import fresh, init, run
#
# VALUES = ["87.25", "64", "np.float32(12.5)", "0.0", "None", "True", "nan"]  # try your own
#
# %start
# init()
# desk = fresh(LevelDesk, VALUES)  # requests one call after another, and records the values that arrive
# try:
#     await run(desk, seconds=10, until=lambda: desk.done)
# except TimeoutError:
#     print("Not all of the calls came back.")
# print(desk.table())
# %% [hint]
# Write the shortest method that could work: create a `Float32` and publish it. Then start it and look at the table.
# In which rows does the value that arrives differ from the value that you gave? You'll see two different problems:
#
# - A **number** of a type other than `float` arrives as 0.0.
# - A value that's **not a number** is published as if it were one.
#
# The first problem needs a conversion. The second needs a check *before* the conversion.
#
# Field types and their Python types: [About
# interfaces](https://docs.ros.org/en/jazzy/Concepts/Basic/About-Interfaces.html)
# %% [hint]
# - `float(64)`, `float(np.float32(12.5))`, and `float(np.int64(7))` are Python floats with the correct value.
# - But `float(True)` is 1.0, `float("50")` is 50.0, and `float("nan")` is nan. So `float()` alone isn't a check.
# - `numbers.Real` in the standard library covers real numbers of any type, including NumPy's:
#   `isinstance(level, Real)`. The result is False for a string, a list, and `None`. But it's True for a `bool`, so
#   check for `bool` first.
# - `math.isfinite(level)` is False for nan and inf.
# - Raise an error with `raise TypeError("...")`. Don't catch it in your method, because it's meant for the caller.
# - `if not level` isn't a test for a missing value, because it's also true for `0.0`.
#
# Nodes and their publishers: [rclpy](https://docs.ros.org/en/jazzy/p/rclpy)
# %% [hint]
# Here's the method with gaps:
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
# - **List the accepted types.** `isinstance(level, (int, float, np.integer, np.floating))` shows all accepted types
#   in one line, but it needs NumPy. `numbers.Real` works without importing NumPy and accepts fractions as well. With
#   both, you have to refuse a bool yourself.
# - **Use `functools.singledispatchmethod`.** You write one method per type, and one that raises an error for
#   everything else. This is useful if each type needs different code. Here, all of them need the same code.
# - **Ask for forgiveness.** Call `charge = float(level)` in a `try`, and refuse only `str` and `bool` yourself. This
#   is shorter. But you have to list every type that you don't want, and it's easy to forget one: `float()`
#   parses bytes, too.
# - **Use `Float32(data=float(level), check_fields=True)`.** This turns on field checks for one message, wherever the
#   program runs. The checks catch a wrong type and a number too large for 32 bits. But they accept nan, and after
#   `float()`, the type is always correct.
# - **Set `ROS_PYTHON_CHECK_FIELDS=1` for the whole robot.** This is a good and cheap second check. As the only check,
#   it refuses valid ints. It has no effect on a robot where it isn't set, or where Python runs with `-O`.
# - **Publish `nan` for an unknown charge.** `sensor_msgs/msg/BatteryState` does this, and its definition says so.
#   Without such a rule, a subscriber that tests `level < 20` gets False and assumes that the charge is fine.
