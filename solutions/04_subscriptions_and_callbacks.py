# ---
# exercise: 04_subscriptions_and_callbacks
# title: A battery monitor
# minutes: 25
# difficulty: 2
# kind: program
# clock: simulated
# objectives:
#   - subscribing to a topic with the right name, type, and queue depth
#   - writing a callback that decides what happens to each message
#   - forwarding messages in the order of arrival
#   - reacting once, and only once, to an impossible value
# out_of_scope:
#   - timers and rates; the node acts only when a message arrives
#   - guessing what a bad reading should have been
#   - how the program ends (lesson 01 judges that)
# ---
# %% [markdown]
# # Exercise 04 · A battery monitor
#
# The guide robot has a new battery sensor and a bad cable. Most readings are correct. But whenever the cable is jolted,
# the sensor publishes an impossible reading. Last week, the robot acted on one of these readings and lay down in the
# middle of the hall. The cable can't be replaced until spring. Until then, a monitor has to filter the readings: it
# passes on the good ones and raises an alarm for each bad one. The robot's other programs will subscribe to your
# monitor's topics instead of the sensor's. A second robot with the same kind of sensor works in the same hall. Your
# monitor must ignore that robot's sensor.
#
# **About 25 minutes · difficulty 2 of 5 · 10 points.** This exercise builds on lesson
# [04](../notebooks/04_subscriptions_and_callbacks.ipynb).
#
# ## What to build
#
# Write one program that spins until it's stopped.
#
# | topic | type | your node | content |
# |---|---|---|---|
# | `/robot/battery` | `Float32` | subscribes | charge in percent: about ten readings a second, sometimes in a burst of four |
# | `/monitor/battery` | `Float32` | publishes | each good reading, unchanged, within {{AT_ONCE_S}} s, and in the order of arrival |
# | `/monitor/alarm` | `String` | publishes | one message for each bad reading, with a text that contains the reading's value, as in `bad reading: -3.0` (one decimal place is enough) |
#
# | a reading is | if | your node |
# |---|---|---|
# | good | it's between 0 and 100 %, inclusive, no matter what the previous readings were | passes it on and raises no alarm |
# | bad | it's below 0, above 100 (including `inf`), or not a number (`nan`) | raises one alarm and doesn't pass the reading on |
#
# All message types are from `std_msgs.msg`.
#
# ## What is judged
#
# Your program runs as a separate process. The judge publishes about fifty readings, both good and bad, on
# `/robot/battery`, and a few on `/other_robot/battery`. Then it compares these readings with the messages that your
# program published.
#
# | points | criterion |
# |---:|---|
# | 1 | the program subscribes to `/robot/battery` with the type `Float32` |
# | 1 | `/monitor/battery` carries `Float32` messages |
# | 2 | every good reading is passed on within {{AT_ONCE_S}} s, and in the order of arrival |
# | 1 | neither a bad reading nor a substitute for one appears on `/monitor/battery` |
# | 1 | `/monitor/alarm` carries `String` messages |
# | 2 | each bad reading raises exactly one alarm, which contains the reading's value |
# | 1 | good readings raise no alarm |
# | 1 | the program ignores `/other_robot/battery` |
#
# You may structure the program any way you like: with a class or just functions, one node or two, and any executor.
# Because the machine may be busy, up to one good reading in ten may be delayed by more than {{AT_ONCE_S}} s.
#
# **Not judged:** publishing rates, how soon an alarm follows a bad reading, and how your program ends on Ctrl-C.
# %% [answer]
"""Check a battery sensor's readings: pass on good ones, and raise an alarm for bad ones."""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Float32, String

EMPTY, FULL = 0.0, 100.0


class BatteryMonitor(Node):
    """Checks each reading before the rest of the robot receives it.

    Subscriptions:
        /robot/battery (std_msgs/Float32): charge in percent, as the sensor measures it.

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
        """Pass the reading on if it is good, and raise an alarm if it is bad."""
        # [solution]
        if EMPTY <= message.data <= FULL:
            self.battery_publisher.publish(message)
        else:  # this includes nan, which isn't between any two numbers
            self.alarm_publisher.publish(String(data=f"bad reading: {message.data}"))
        # [starter]
        # | # TODO 3: if message.data is a charge from 0 to 100 %, publish it; otherwise, publish an alarm
        # [end]


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or SIGTERM, then exit with code 0."""
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
# READINGS = [64.0, 63.5, -3.0, 63.0, 62.5]  # the sensor's readings; try your own
#
# init()
# desk = fresh(BatteryDesk, READINGS)  # while it's in the graph, the robot's own sensor pauses
# %start
# await run(desk, seconds=8, until=lambda: desk.done)
# desk.destroy_node()  # from now on, the robot's sensor publishes again
# print(desk.table())
# %% [hint]
# Begin with the subscription. At first, let its callback only call `self.get_logger().info(str(message.data))`. Start
# the program and read its log. Which of the logged values can be a charge? Then answer two questions about a single
# message: is it good, and where should it go?
#
# More about topics, and how nodes use them: [About
# topics](https://docs.ros.org/en/jazzy/Concepts/Basic/About-Topics.html)
# %% [hint]
# - You need three lines in `__init__`: `self.create_publisher(type, topic, depth)` twice, and
#   `self.create_subscription(type, topic, self.on_battery, depth)` once. Pass the method without parentheses. Create
#   the publishers here, not in the callback, because subscriptions need a moment to discover them.
# - In the callback, publish right away. rclpy calls the callback once for each message, in the right order, so you
#   don't need a list, a loop, or a timer.
# - Try `float("nan") < 0`, `float("nan") > 100`, and `float("nan") == float("nan")` in a cell. Which condition gives
#   the right result for `nan`, too?
#
# All methods of a node: [rclpy](https://docs.ros.org/en/jazzy/p/rclpy)
# %% [hint]
# The node, with gaps to fill in:
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
# - **Publish the received message or a new one.** `publish(message)` passes on the same message, so nothing is copied
#   and you can't forget a field. `publish(Float32(data=message.data))` shows more clearly which value is sent. It also
#   stays correct if the two topics ever get different types.
# - **Test for bad readings.** `math.isnan(x) or x < 0.0 or x > 100.0` is correct, too, but you must think of every kind
#   of bad reading. A test for good readings also rejects the kinds that you didn't think of.
# - **Return early.** With `if not good: alarm; return`, the usual case stays at the left margin. This pays off as soon
#   as there is more than one kind of alarm.
# - **Use two nodes.** One node passes readings on and the other raises alarms, each with its own subscription. You can
#   then replace or restart each node separately. But both need the rule for good readings, so put it into one function.
# - **Write a callback with two arguments.** `on_battery(self, message, info)` is useful if the alarm should include the
#   time when the reading was sent. This task doesn't need the second argument.
# - **Collect in the callback, and publish in a timer.** This works if you don't lose any readings in between. But
#   delayed readings are less useful, and you must keep the order yourself. Do this only when subscribers must not
#   receive too many messages.
# - **Use a richer message type on a real robot.** `sensor_msgs/BatteryState` has fields for the charge, the voltage,
#   the current, and whether a battery is present. `Float32` has only one number, but that's enough for learning.
