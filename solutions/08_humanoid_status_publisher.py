# ---
# exercise: 08_humanoid_status_publisher
# title: The humanoid status publisher
# minutes: 20
# difficulty: 2
# kind: program
# clock: simulated
# objectives:
#   - finding a fault by looking at the messages that arrive, not by staring at the code
#   - publishing a number in a float field so that subscribers receive that number
#   - converting a rate in hertz to a timer period
#   - ending a program with exit code 0 on Ctrl-C
# out_of_scope:
#   - adding topics (exercise 09 does that)
#   - reading a real battery (BatteryState) and what the robot should do when it is empty
#   - ending on SIGTERM, and parameters for rates
# ---
# %% [markdown]
# # Exercise 08 · The humanoid status publisher
#
# The night shift left you a note: *"A colleague cleaned up the status publisher yesterday. It starts, it logs, and it
# looks fine. But the dashboard says the battery is at 0 %, even though the robot is still walking around. The battery
# topic is busier than it should be. And the service manager reports a crash every time we stop the program."* There are
# three bugs, one behind each complaint. Fix them. The rest of the program is correct.
#
# **About 20 minutes · difficulty 2 of 5 · 10 points.** This exercise builds on lesson
# [08](../notebooks/08_humanoid_status_publisher.ipynb).
#
# ## What it has to do
#
# | topic | type | rate | content |
# |---|---|---|---|
# | `/robot/status` | `String` | 1 Hz | `operational` while the battery has charge, `error` once it is empty |
# | `/robot/battery` | `Float32` | 0.5 Hz | the charge in percent, which starts at 100, never rises, and never falls below 0 |
#
# On Ctrl-C, the program ends with exit code 0 and without a traceback.
#
# ## What is judged
#
# Your program runs in its own process for {{plan.simulated_s}} s of simulated time, while the judge checks the messages
# that your program publishes. Then the judge sends SIGINT, the signal that Ctrl-C sends, and checks how the program
# ends.
#
# | points | criterion |
# |---:|---|
# | 1 | `/robot/battery` carries `Float32` messages |
# | 2 | the published charge is correct: it starts at 100 % (or about one step lower), then falls, and never drops below 0 |
# | 2 | the charge is published at a steady 0.5 Hz (0.4 to 0.6 Hz, no gap over 3 s) |
# | 1 | `/robot/status` still works: it carries `String` messages at 1 Hz (0.8 to 1.2 Hz, no gap over 1.5 s). Each message contains the word that matches the charge |
# | 1 | the program keeps running until Ctrl-C |
# | 3 | Ctrl-C ends the program with exit code 0 and no traceback |
#
# First, run the program below without changing it. The dashboard under *Watch it run* shows two of the problems, and
# `%check` shows the third. You may fix the three bugs in place or rewrite the program.
#
# The program simulates an old battery that runs out within half a minute, so that the status changes while the judge is
# watching. The status may change to `error` at any time after the last message with a charge above 0. Once two messages
# with a charge of 0 have been published, every status must be `error`.
#
# The charge may fall in unequal steps, and you may round it. So the first charge may be below 100 % by up to
# {{batteries.ROUNDING}} % plus 1.5 times the largest drop between consecutive messages. If your program uses the real
# clock instead of simulated time, the judge may miss the first messages. In that case, the first charge that the judge
# receives may be below 100 % by up to {{batteries.ROUNDING}} % plus four times the largest drop.
#
# **Not judged:** additional topics, reading a real battery, signals other than the one that Ctrl-C sends, your log
# messages, and how fast the battery drains. (If your battery lasts longer than {{plan.simulated_s}} s, the judge simply
# never sees it run out.)
# %% [answer]
"""Simulate a humanoid robot that publishes its status once a second and its battery charge every two seconds."""

import random

import rclpy
# [solution]
from rclpy.executors import ExternalShutdownException
# [end]
from rclpy.node import Node
from std_msgs.msg import Float32, String

STATUS_PERIOD_S = 1.0  # 1 Hz
# [solution]
BATTERY_PERIOD_S = 2.0  # 0.5 Hz: one message every two seconds
# [starter]
# | BATTERY_PERIOD_S = 0.5  # 0.5 Hz
# [end]
DRAIN_PERCENT = (7.0, 10.0)  # a worn battery: empty within half a minute


class HumanoidStatusPublisher(Node):
    """Publishes the robot's status and its battery charge.

    Topics:
        /robot/status (std_msgs/String), 1 Hz: "operational", or "error" once the battery is empty.
        /robot/battery (std_msgs/Float32), 0.5 Hz: charge in percent, from 100 down to 0.
    """

    def __init__(self) -> None:
        super().__init__("humanoid_status_publisher")
        self.battery_level = 100.0
        self.status_publisher = self.create_publisher(String, "/robot/status", 10)
        self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)
        self.status_timer = self.create_timer(STATUS_PERIOD_S, self.publish_status)
        self.battery_timer = self.create_timer(BATTERY_PERIOD_S, self.publish_battery)
        self.get_logger().info("Humanoid status publisher started")

    def publish_status(self) -> None:
        """Publish whether the robot can work."""
        message = String(data="operational" if self.battery_level > 0.0 else "error")
        self.status_publisher.publish(message)
        self.get_logger().info(f"Status: {message.data}")

    def publish_battery(self) -> None:
        """Drain the simulated battery a little, but never below 0 %, and publish its charge."""
        self.battery_level = max(0.0, self.battery_level - random.uniform(*DRAIN_PERCENT))
        # [solution]
        message = Float32(data=self.battery_level)
        # [starter]
        # | message = Float32(data=round(self.battery_level))  # whole percents are easier to read
        # [end]
        self.battery_publisher.publish(message)
        self.get_logger().info(f"Battery: {self.battery_level:.0f} %")


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C."""
    rclpy.init(args=args)
    humanoid = HumanoidStatusPublisher()
    # [solution]
    try:
        rclpy.spin(humanoid)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass  # someone ended the program, which isn't an error
    finally:
        rclpy.try_shutdown()  # Ctrl-C may have shut the context down already
    # [starter]
    # | try:
    # |     rclpy.spin(humanoid)
    # | except KeyboardInterrupt:
    # |     pass
    # | finally:
    # |     humanoid.destroy_node()
    # |     rclpy.shutdown()
    # [end]


if __name__ == "__main__":
    main()
# %% [live]
# from workbook.lesson import watch_status
#
# %start
# view = await watch_status(seconds=10)
# %% [hint]
# Don't read the code yet. Watch the dashboard, and work on one complaint at a time.
#
# - **0 %.** The log shows 92 %, but the topic carries 0. So the level is right in `self.battery_level` and wrong in the
#   message. Which single line is between the two?
# - **Too busy.** Count the battery messages in ten seconds. How many should there be at 0.5 Hz?
# - **The crash.** `%check` shows the last lines of the log after Ctrl-C. Read the very last one first.
#
# This tutorial builds a publisher and a timer step by step: [Writing a simple publisher and
# subscriber](https://docs.ros.org/en/jazzy/Tutorials/Beginner-Client-Libraries/Writing-A-Simple-Py-Publisher-And-Subscriber.html)
# %% [hint]
# - **0 %.** Run `type(round(92.4))` in Python. Then look up which Python type a `float32` field needs. (With a second
#   argument, `round` returns a different type.)
# - **Too busy.** `create_timer` takes a *period* in seconds, but the comment next to the number gives a *frequency*.
#   The period is 1 divided by the frequency.
# - **The crash.** On Ctrl-C, rclpy shuts the context down on its own. Which function does the program then call, even
#   though the context is already shut down? rclpy has another function that raises no exception in this case; its name
#   begins with `try_`. And `spin` may raise another exception: `rclpy.executors.ExternalShutdownException`.
#
# Field types and their Python types: [About
# interfaces](https://docs.ros.org/en/jazzy/Concepts/Basic/About-Interfaces.html)
# %% [hint]
# The three places, with gaps:
#
# ```python
# BATTERY_PERIOD_S = ___  # 0.5 Hz: one message every ... seconds
#
#     message = Float32(data=___(self.battery_level))  # or the level as it is
#
#     try:
#         rclpy.spin(humanoid)
#     except (KeyboardInterrupt, ___):
#         pass
#     finally:
#         rclpy.___()
# ```
#
# The functions that begin and end a program: [rclpy](https://docs.ros.org/en/jazzy/p/rclpy)
# %% [alternatives]
# ## Other good ways
#
# - **`float(round(self.battery_level))`.** This publishes whole percents, but as a float. `round(level, 1)` also
#   returns a float. It's better to publish the exact number and round it where it's *displayed*, because a subscriber
#   may need the decimals.
# - **Check `rclpy.ok()` before `rclpy.shutdown()`.** `if rclpy.ok(): rclpy.shutdown()` does the same as
#   `try_shutdown()`, with more code.
# - **`destroy_node()` in `finally`.** This isn't wrong, because you may call it after the context is shut down. But it
#   isn't needed here, because the process ends. It matters in a program that continues without the node.
# - **No `ExternalShutdownException`.** On Ctrl-C, `spin` raises `KeyboardInterrupt`, so catching that exception is
#   enough here. `spin` raises the other exception if something else shut the context down. Examples are a SIGTERM from
#   a service manager, or a program that was started with Ctrl-C ignored. If you catch both, you don't need to think
#   about the cause.
# - **`signal_handler_options=SignalHandlerOptions.NO` in `rclpy.init`.** With this option, rclpy doesn't handle
#   signals. So the context is still valid after Ctrl-C, and a plain `rclpy.shutdown()` is right. Use it if you need to
#   publish a last message, because `/robot/status` can be published only while the context is valid.
# - **`sensor_msgs/msg/BatteryState`.** Real robots publish this type. It contains the voltage, the current, the charge
#   from 0 to 1, the health of the cells, and a time stamp. `Float32` doesn't even state that the unit is percent.
