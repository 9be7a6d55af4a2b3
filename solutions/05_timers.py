# ---
# exercise: 05_timers
# title: Three rates in one robot
# minutes: 20
# difficulty: 2
# kind: program
# clock: simulated
# objectives:
#   - using a timer for repeated work, instead of a loop that sleeps
#   - converting a frequency in hertz to a period in seconds
#   - running three timers in one node without letting any of them delay the others
# out_of_scope:
#   - real sensors; all values are simulated and only their rates are judged
#   - slow callbacks (lesson 10)
#   - how the program ends (lesson 01 judges that) and how the code is written
# ---
# %% [markdown]
# # Exercise 05 · Three rates in one robot
#
# Your humanoid leaves the workshop for its first walk. A remote operator needs the answers to three questions. Is
# the robot alive? To answer that, one heartbeat a second is enough. How much charge is left? The battery level changes
# slowly, so a message every two seconds is enough. Is the robot about to fall? A fall takes only a second, so the
# operator needs the body's tilt five times a second. Your node publishes all three, each at its own rate.
#
# **About 20 minutes · difficulty 2 of 5 · 10 points.** This exercise builds on lesson
# [05](../notebooks/05_timers.ipynb).
#
# ## What to build
#
# | topic | type | rate | content |
# |---|---|---:|---|
# | `/robot/heartbeat` | `String` | 1 Hz | a sign of life: any nonempty text, such as `alive` |
# | `/robot/battery` | `Float32` | 0.5 Hz | charge in percent |
# | `/robot/tilt` | `Float32` | 5 Hz | the body's tilt in rad |
#
# All message types are from `std_msgs.msg`. The starter code already publishes the heartbeat. Your task is to add the
# battery and the tilt. You can choose their values, as long as they are floats. (With this course's ROS build, an `int`
# arrives as 0.0; with the ROS packages for Ubuntu, it may crash the node.) Apart from their type, the values aren't
# judged.
#
# ## What is judged
#
# Your program runs in its own process for one minute of simulated time, which takes only a few seconds of real time.
# The judge counts the messages on each topic. Each count is allowed to be off by one, because the first or last message
# can fall just inside or just outside the minute. *Evenly spaced* means that consecutive messages arrive about one
# period apart, and never more than one and a half periods apart. The mean interval may differ from the period by at
# most {{rates.MEAN_TOLERANCE %}}, and the median interval by at most {{rates.INTERVAL_TOLERANCE %}}. If your program
# uses the real clock instead of simulated time, the judge records its messages for at least 8.5 s of real time. In that
# case, only the longest interval and the median interval are judged.
#
# | points | criterion |
# |---:|---|
# | 1 | `/robot/heartbeat` exists and carries `String` messages |
# | 2 | 60 evenly spaced heartbeats in the minute |
# | 1 | `/robot/battery` exists and carries `Float32` messages |
# | 2 | 30 evenly spaced battery reports in the minute |
# | 1 | `/robot/tilt` exists and carries `Float32` messages |
# | 2 | 300 evenly spaced tilt values in the minute |
# | 1 | the program is still running at the end |
#
# You may structure the program any way you like: with three timers, one timer and a counter, several nodes, or a
# different executor.
#
# **Not judged:** real sensors, slow callbacks, other topics, and how your program ends on Ctrl-C.
# %% [answer]
"""Publish a humanoid's vital signs: its heartbeat, battery charge, and tilt, each at its own rate."""

import math

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Float32, String

HEARTBEAT_PERIOD_S = 1.0  # 1 Hz
# [solution]
BATTERY_PERIOD_S = 2.0  # 0.5 Hz: one message every two seconds
TILT_PERIOD_S = 0.2  # 5 Hz: five messages every second
# [starter]
# | # TODO 1: publish the battery at 0.5 Hz and the tilt at 5 Hz. What are the periods in seconds?
# [end]


class VitalSigns(Node):
    """Publishes a sign of life, the battery's charge, and the body's tilt.

    Topics:
        /robot/heartbeat (std_msgs/String), 1 Hz: "alive".
        /robot/battery (std_msgs/Float32), 0.5 Hz: charge in percent, from 100.0 down to 0.0.
        /robot/tilt (std_msgs/Float32), 5 Hz: the body's tilt in rad.
    """

    def __init__(self) -> None:
        super().__init__("vital_signs")
        self.heartbeat_publisher = self.create_publisher(String, "/robot/heartbeat", 10)
        self.create_timer(HEARTBEAT_PERIOD_S, self.publish_heartbeat)
        # [solution]
        self.battery_level = 100.0
        self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)
        self.tilt_publisher = self.create_publisher(Float32, "/robot/tilt", 10)
        self.create_timer(BATTERY_PERIOD_S, self.publish_battery)
        self.create_timer(TILT_PERIOD_S, self.publish_tilt)
        # [starter]
        # | # TODO 2: create the publishers for /robot/battery and /robot/tilt
        # | # TODO 3: create a timer for each of them
        # [end]

    def publish_heartbeat(self) -> None:
        """Publish a sign of life."""
        self.heartbeat_publisher.publish(String(data="alive"))

    # [solution]
    def publish_battery(self) -> None:
        """Drain the simulated battery a little, but never below 0 %, and publish its charge."""
        self.battery_level = max(0.0, self.battery_level - 0.2)
        self.battery_publisher.publish(Float32(data=self.battery_level))

    def publish_tilt(self) -> None:
        """Publish the body's current tilt. The body sways from side to side as the robot walks."""
        seconds = self.get_clock().now().nanoseconds / 1e9
        self.tilt_publisher.publish(Float32(data=0.1 * math.sin(math.pi * seconds)))

    # [starter]
    # | # TODO 4: write the two methods that your timers call. Each creates a Float32 message,
    # | #         sets its data to a float, and publishes it.
    # |
    # [end]


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(VitalSigns())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
# %% [hint]
# The starter code's heartbeat already has every part that you need: a publisher, a timer, and a method that publishes.
# What has to change in each part for a new topic? Watch the units: the task gives messages per second, but a timer
# needs the seconds between two messages.
#
# Nodes, topics, and more: [Basic concepts](https://docs.ros.org/en/jazzy/Concepts/Basic.html)
# %% [hint]
# - The period is 1 divided by the frequency: `1 / 0.5` for the battery, `1 / 5` for the tilt. The lower frequency has
#   the longer period.
# - In `self.create_timer(period, self.publish_battery)`, pass the method without `()`. With `()`, you'd call it right
#   away and pass its return value.
# - Timers are independent of each other. You can create as many as you like, with one line each.
# - Pass a float to the message, as in `Float32(data=0.0)`. An int, as in `Float32(data=100)`, would arrive as 0.0.
#
# All methods of a node: [rclpy](https://docs.ros.org/en/jazzy/p/rclpy)
# %% [hint]
# Here's the battery's code, with gaps. The tilt's code has the same structure.
#
# ```python
# BATTERY_PERIOD_S = ___
#
# # in __init__
# self.battery_publisher = self.create_publisher(___, "/robot/battery", 10)
# self.create_timer(___, self.publish_battery)
#
# def publish_battery(self) -> None:
#     self.battery_publisher.publish(Float32(data=97.5))
# ```
#
# A timer and a publisher, step by step: [Writing a simple publisher and
# subscriber](https://docs.ros.org/en/jazzy/Tutorials/Beginner-Client-Libraries/Writing-A-Simple-Py-Publisher-And-Subscriber.html)
# %% [alternatives]
# ## Other good ways
#
# - **Use one timer and a counter.** A single 5 Hz timer publishes the tilt at each tick, the heartbeat at every 5th
#   tick, and the battery at every 10th. So all three always stay in step. But now the rates depend on each other: a
#   heartbeat at 0.7 Hz would force you to rewrite the timer.
# - **Write `1 / 5` instead of `0.2`.** With `TILT_HZ = 5.0` and `create_timer(1.0 / TILT_HZ, ...)`, the code shows the
#   same number as the task. This is useful if other people will change the rate.
# - **Store the timer in an attribute.** You don't need `self.tilt_timer = self.create_timer(...)` to keep the timer
#   alive, because the node stores it. An attribute is useful if you want to call the timer's `cancel()` or `reset()`
#   later.
# - **Use three nodes with one rate each.** This is right if the parts have different jobs or may fail independently.
#   For three timers, it's too much.
# - **Write a loop with `sleep`.** This works for one rate, but it drifts. With three rates, you must compute which
#   message is due next, and when. That's the timers' job.
