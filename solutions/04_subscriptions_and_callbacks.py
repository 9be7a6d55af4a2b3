# ---
# exercise: 04_subscriptions_and_callbacks
# title: A monitor for the battery
# minutes: 25
# difficulty: 2
# kind: program
# clock: simulated
# objectives:
#   - subscribe to a topic with the right name, type and depth
#   - write a callback that decides what becomes of each message
#   - pass messages on in the order in which they came
#   - react once, and only once, to what cannot be
# out_of_scope:
#   - timers and rates; the node does something only when a message comes
#   - guessing what a bad reading should have been
#   - how the program ends (lesson 01 judges that)
# ---
# %% [markdown]
# # Exercise 04 · A monitor for the battery
#
# The guide robot has a new battery sensor, and a bad cable. Mostly the charge comes through. Now and then the cable
# shakes, and the sensor says something that no battery can say. Last week the robot believed it and lay down in the
# middle of the hall. Replacing the cable takes until spring. So you write a monitor: it listens to the sensor, passes
# on what can be, and raises an alarm at what cannot. The rest of the robot then listens to the monitor. A second robot
# works in the same hall, with the same kind of sensor. It is none of your business.
#
# **About 25 minutes · difficulty 2 of 5 · 10 points.** You need lesson
# [04](../notebooks/04_subscriptions_and_callbacks.ipynb).
#
# ## What to build
#
# One program that is spun until somebody ends it.
#
# | topic | type | your node | content |
# |---|---|---|---|
# | `/robot/battery` | `Float32` | listens | charge in percent, about ten times a second, sometimes four at the same moment |
# | `/monitor/battery` | `Float32` | speaks | each good reading: the same number, at once (within 0.5 s), in the same order |
# | `/monitor/alarm` | `String` | speaks | one text for each bad reading, with its value in it, such as `bad reading: -3.0`; one decimal is enough |
#
# | a reading is | when | your node |
# |---|---|---|
# | good | it is from 0 to 100 %, both included, whatever came before it | passes it on, raises no alarm |
# | bad | it is anything else: below 0, above 100 (`inf`, too), or not a number (`nan`) | does not pass it on, raises one alarm |
#
# The message types are those of `std_msgs.msg`.
#
# ## What is judged
#
# Your program runs as a process of its own. The judge publishes about fifty readings on `/robot/battery`, good and bad
# ones, and a few on `/other_robot/battery`. Then it compares what your program published with what it said.
#
# | points | criterion |
# |---:|---|
# | 1 | it listens to `/robot/battery`, with the type `Float32` |
# | 1 | `/monitor/battery` carries `Float32` |
# | 2 | all good readings are passed on, at once, in the right order |
# | 1 | no bad reading is passed on, and nothing in its place |
# | 1 | `/monitor/alarm` carries `String` |
# | 2 | one alarm for each bad reading, with its value |
# | 1 | no alarm for good readings |
# | 1 | it is silent about `/other_robot/battery` |
#
# Any shape of program will do: a class, a function as a callback, two nodes, another executor. On a busy machine one
# good reading in ten may come later than 0.5 s.
#
# **Not part of it:** rates, how fast an alarm comes, repairing bad readings, and how your program ends on Ctrl-C.
# %% [answer]
"""Listens to the battery sensor, passes on what can be, and raises an alarm at what cannot."""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Float32, String

EMPTY, FULL = 0.0, 100.0


class BatteryMonitor(Node):
    """Stands between the battery sensor and all who want to know the charge.

    Subscriptions:
        /robot/battery (std_msgs/Float32): charge in percent, as the sensor says it.

    Topics:
        /monitor/battery (std_msgs/Float32): charge in percent, good readings only.
        /monitor/alarm (std_msgs/String): one text for each bad reading.
    """

    def __init__(self) -> None:
        super().__init__("battery_monitor")
        # [solution]
        self.battery_publisher = self.create_publisher(Float32, "/monitor/battery", 10)
        self.alarm_publisher = self.create_publisher(String, "/monitor/alarm", 10)
        self.create_subscription(Float32, "/robot/battery", self.on_battery, 10)
        # [starter]
        # | # TODO 1: create the publishers for /monitor/battery and /monitor/alarm
        # | # TODO 2: create a subscription to /robot/battery that calls self.on_battery
        # [end]

    def on_battery(self, message: Float32) -> None:
        """Pass the reading on if it can be, and raise an alarm if it cannot."""
        # [solution]
        if EMPTY <= message.data <= FULL:
            self.battery_publisher.publish(message)
        else:  # also when it is nan: no comparison with nan is true
            self.alarm_publisher.publish(String(data=f"bad reading: {message.data}"))
        # [starter]
        # | # TODO 3: is message.data a charge from 0 to 100 %? Publish it, or else publish an alarm
        # [end]


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or a request to end, then leave with exit code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(BatteryMonitor())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
# %% [live]
# from lesson_nodes.battery_desk import BatteryDesk
# from workbook.lesson import fresh, init, run
#
# READINGS = [64.0, 63.5, -3.0, 63.0, 62.5]  # what the sensor says; try your own
#
# %start
# init()
# desk = fresh(BatteryDesk, READINGS)
# await run(desk, seconds=8, until=lambda: desk.done)
# print(desk.table())
# %% [hint]
# Begin with the ears. Make the subscription, and let the callback do nothing but
# `self.get_logger().info(str(message.data))`. Start it, look at what comes, and what of it can be a charge. Then think
# about two questions, each for one message alone: is it good? Where does it go?
#
# What a topic is, and who hears whom: [About topics](https://docs.ros.org/en/jazzy/Concepts/Basic/About-Topics.html)
# %% [hint]
# - Three lines in `__init__`: two times `self.create_publisher(type, topic, depth)`, once
#   `self.create_subscription(type, topic, self.on_battery, depth)`. Hand over the method without parentheses. Make the
#   publishers here and not in the callback: others need a moment to find them.
# - In the callback, publish at once. It is called once for each message, in the right order; you need no list, no loop
#   and no timer.
# - Try `float("nan") < 0`, `float("nan") > 100` and `float("nan") == float("nan")` in a cell. Which question about a
#   reading has an answer that is right for `nan`, too?
#
# What a node offers: [rclpy](https://docs.ros.org/en/jazzy/p/rclpy)
# %% [hint]
# The node with gaps:
#
# ```python
# self.battery_publisher = self.create_publisher(Float32, "/monitor/battery", 10)
# self.alarm_publisher = self.create_publisher(___, ___, 10)
# self.create_subscription(___, "/robot/battery", ___, 10)
#
# def on_battery(self, message: Float32) -> None:
#     if ___ <= message.data <= ___:  # is it good? False for nan
#         self.battery_publisher.publish(___)
#     else:
#         self.alarm_publisher.publish(String(data=f"bad reading: {___}"))
# ```
#
# A publisher and a subscriber, step by step: [Writing a simple publisher and
# subscriber](https://docs.ros.org/en/jazzy/Tutorials/Beginner-Client-Libraries/Writing-A-Simple-Py-Publisher-And-Subscriber.html)
# %% [alternatives]
# ## Other good ways
#
# - **Publish the message that came, or a new one.** `publish(message)` passes on the very message: no copy, and no
#   field can be forgotten. `publish(Float32(data=message.data))` says more plainly what goes out, and stays right when
#   the two types part ways one day.
# - **Ask what is bad.** `math.isnan(x) or x < 0.0 or x > 100.0` is right as well. But each kind of bad has to be
#   thought of. Asking what is good covers those that nobody thought of, too.
# - **Early return.** `if not good: alarm; return` keeps the usual case at the left margin. Pleasant as soon as there
#   is more than one kind of alarm.
# - **Two nodes**, one that passes on and one that warns, each with a subscription of its own. Each can then be
#   replaced or restarted alone. The price: the rule of what is good stands in two places, so put it into one function.
# - **A callback with two arguments**, `on_battery(self, message, info)`, if the alarm should say when the reading was
#   sent. For this task it is one argument more than needed.
# - **Collect in the callback, publish in a timer.** It works if nothing is forgotten in between, but what comes late
#   is of little use, and the order is now your affair. Right only where others must not be flooded.
# - **The type of the future.** `sensor_msgs/BatteryState` has fields for charge, voltage, current and for whether a
#   battery is there at all. `Float32` says none of that; it is fine for learning.
