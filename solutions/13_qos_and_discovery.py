# ---
# exercise: 13_qos_and_discovery
# title: The late dashboard
# minutes: 30
# difficulty: 3
# kind: program
# clock: wall
# objectives:
#   - request a QoS that fits what is offered, for each topic its own
#   - have the last status at once, although it was said before the program started
#   - notice a silence, which calls no callback
#   - keep one's own state for those who come even later
# out_of_scope:
#   - what the robot should do about the alarm
#   - liveliness and lifespan, and settings of a certain DDS
#   - how the program ends on Ctrl-C (lesson 01 judges that)
# ---
# %% [markdown]
# # Exercise 13 · The late dashboard
#
# The night nurse comes on duty and switches on the dashboard of the ward robot. The robot has been up for hours. It said
# `operational` this morning, and since then it had no reason to say it again. The nurse wants to see it *now*. And if the
# heart of the robot falls silent in the middle of the night, the dashboard must raise an alarm within three seconds. Not
# for every hiccup, or she will stop listening. And not for ever: when the heart beats again, the alarm is over.
#
# **About 30 minutes · difficulty 3 of 5 · 10 points.** You need lesson
# [13](../notebooks/13_qos_and_discovery.ipynb).
#
# ## What there is
#
# | topic | type | what the robot says | what it offers |
# |---|---|---|---|
# | `/robot/status` | `String` | `operational` or `error`, only when it changes | reliable, transient local, depth 1, no deadline |
# | `/robot/heartbeat` | `String` | `beat 1`, `beat 2`, …, every 0.25 s | best effort, volatile, deadline 0.5 s |
#
# ## What to build
#
# | topic | type | when | content |
# |---|---|---|---|
# | `/dashboard/line` | `String` | 2 Hz, always | the last status that it has heard of, for example `status: error`; `unknown` only before that; never two of these words |
# | `/dashboard/alarm` | `Bool` | when it changes, or more often | see below; kept for those who come later |
#
# What was said before the program started stands on the line at the latest 1 s after the start, and a new status at the
# latest 0.8 s after the robot has said it.
#
# The alarm is raised (`True`) when no beat has come for about 2 s: never before 1 s, and 3 s after the last beat at the
# latest. It lasts until the heart beats again, and ends (`False`) at the latest 1.5 s after that. Before the first beat it
# may say what it likes.
#
# ## What is judged
#
# Your program runs as a process of its own, for eleven real seconds. The judge plays the robot. It has said its status
# before your program starts, and changes it now and then. One beat comes late, and twice the heart stops for almost four
# seconds. In between it beats again.
#
# | points | criterion |
# |---:|---|
# | 1 | `/dashboard/line` exists and carries `String` |
# | 1 | the line comes at 2 Hz, and goes on while there is an alarm |
# | 2 | it knows at once what was said before it started |
# | 1 | the line follows when the status changes |
# | 1 | it hears the heartbeat |
# | 1 | `/dashboard/alarm` carries `Bool`, and is kept for those who come later (reliable, transient local) |
# | 1 | the alarm is raised within 3 s of silence |
# | 1 | no alarm before it is due |
# | 1 | the alarm ends when the heart beats again |
#
# What a busy machine may cost: 2 Hz means 1.8 to 2.2 Hz, typically one line every 0.45 to 0.55 s, and no silence over
# 1.25 s. Alarms may be raised, and end, 0.2 s later than said above.
#
# **Not part of it:** what the line says in the first second, and whether it comes then; whether the alarm is published more
# often than it changes; and how your program ends.
# %% [answer]
"""A dashboard that may come late: it knows the last status at once, and notices when the robot falls silent."""

# [solution]
import time

# [end]
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
# [solution]
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from std_msgs.msg import Bool, String
# [starter]
# | from std_msgs.msg import String
# [end]

LINE_PERIOD_S = 0.5
# [solution]
LOOK_PERIOD_S = 0.2
LONGEST_SILENCE_S = 2.0

STATE_QOS = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)  # reliable by default
BEAT_QOS = QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT)
# [end]


class Dashboard(Node):
    """Shows the last status of the robot, and raises an alarm when its heart is silent."""

    def __init__(self) -> None:
        super().__init__("dashboard")
        self.last_status = "unknown"
        self.line_publisher = self.create_publisher(String, "/dashboard/line", 10)
        # [solution]
        self.last_beat = time.monotonic()  # none yet: a heart that never beats is as silent as one that stops
        self.alarm: bool | None = None
        self.alarm_publisher = self.create_publisher(Bool, "/dashboard/alarm", STATE_QOS)
        self.create_subscription(String, "/robot/status", self.on_status, STATE_QOS)
        self.create_subscription(String, "/robot/heartbeat", self.on_beat, BEAT_QOS)
        self.create_timer(LOOK_PERIOD_S, self.look_at_the_clock)
        # [starter]
        # | # TODO 1: ask for what was said before, too
        # | self.create_subscription(String, "/robot/status", self.on_status, 10)
        # | # TODO 2: subscribe to /robot/heartbeat, and note when the last beat came
        # | # TODO 3: publish /dashboard/alarm (Bool), kept for those who come later
        # | # TODO 4: notice the silence: who calls you when nothing comes?
        # [end]
        self.create_timer(LINE_PERIOD_S, self.publish_line)

    def on_status(self, message: String) -> None:
        """Remember the status."""
        self.last_status = message.data

    # [solution]
    def on_beat(self, message: String) -> None:
        """Remember when the last beat came."""
        self.last_beat = time.monotonic()

    def look_at_the_clock(self) -> None:
        """Raise the alarm when the last beat is long ago, take it back when it is not."""
        alarm = time.monotonic() - self.last_beat > LONGEST_SILENCE_S
        if alarm != self.alarm:
            self.alarm = alarm
            self.alarm_publisher.publish(Bool(data=alarm))

    # [end]
    def publish_line(self) -> None:
        """Show what is known."""
        self.line_publisher.publish(String(data=self.last_status))


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C."""
    rclpy.init(args=args)
    try:
        rclpy.spin(Dashboard())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
# %% [live]
# from lesson_nodes import heartbeat
# from workbook.lesson import start, stop
# from workbook.ros import topic_echo
#
# start(heartbeat, beats_for_s=5.0, silent_for_s=4.0)  # a robot whose heart falls silent now and then
# %start
# for message in topic_echo("/dashboard/line", count=8, timeout=8.0).messages:  # try /dashboard/alarm, too
#     print(message.data)
# stop(heartbeat)
# %% [hint]
# Two topics, two offers, so two QoS profiles. Take the table *What there is* and ask for each line: what do I need, and is
# that not more than is offered? A plain `10` asks for reliable, and for nothing that was said before.
#
# For the alarm there is another question. A callback is called when a message comes. In the silence none comes. What in a
# node calls you all the same?
#
# All policies with their defaults: [About quality of service
# settings](https://docs.ros.org/en/jazzy/Concepts/Intermediate/About-Quality-of-Service-Settings.html)
# %% [hint]
# - **Status at once:** `QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)` for the subscription. The same
#   profile suits the publisher of your alarm, for the same reason.
# - **Heartbeat:** `reliability=ReliabilityPolicy.BEST_EFFORT`, or `qos_profile_sensor_data`.
# - **Silence:** either a timer that compares `time.monotonic()` with the time of the last beat, or
#   `SubscriptionEventCallbacks(deadline=...)`. If you request a deadline: not shorter than the 0.5 s that are offered, and
#   it is told again and again until the next beat.
# - **The end of the alarm** is not told by the event. You know it when a beat comes.
#
# Publishers and subscriptions with their QoS: [rclpy](https://docs.ros.org/en/jazzy/p/rclpy)
# %% [hint]
# With gaps:
#
# ```python
# STATE_QOS = QoSProfile(depth=1, durability=DurabilityPolicy.___)
# BEAT_QOS = QoSProfile(depth=5, reliability=ReliabilityPolicy.___)
#
#         self.last_beat = time.monotonic()  # the silence before the first beat counts, too
#         self.alarm: bool | None = None
#         self.create_subscription(String, "/robot/status", self.on_status, ___)
#         self.create_subscription(String, "/robot/heartbeat", self.on_beat, ___)
#         self.alarm_publisher = self.create_publisher(Bool, "/dashboard/alarm", ___)
#         self.create_timer(0.2, self.look_at_the_clock)
#
#     def on_beat(self, message: String) -> None:
#         self.last_beat = time.monotonic()
#
#     def look_at_the_clock(self) -> None:
#         alarm = time.monotonic() - ___ > 2.0
#         if alarm != self.alarm:
#             self.alarm = alarm
#             self.alarm_publisher.publish(Bool(data=___))
# ```
#
# `QoSProfile`, `DurabilityPolicy` and `ReliabilityPolicy` come from `rclpy.qos`. Why late joiners need them:
# [About quality of service settings](https://docs.ros.org/en/jazzy/Concepts/Intermediate/About-Quality-of-Service-Settings.html)
# %% [alternatives]
# ## Other good ways
#
# - **The deadline event.** `QoSProfile(..., deadline=Duration(seconds=2.0))` and
#   `event_callbacks=SubscriptionEventCallbacks(deadline=self.on_missed)`. The middleware keeps the time and your node need not
#   look at any clock. The price: the publisher must offer a deadline, or you hear nothing at all, and you learn of that only
#   by a line in the log. It starts with the first message.
# - **A timer that is wound up again.** `self.watchdog = self.create_timer(2.0, self.on_silence)`, and `self.watchdog.reset()`
#   at every beat. It fires only when nobody has wound it up for 2 s. Short and clear. It, too, fires if no beat ever came.
# - **`last_beat = None` until the first beat,** and no alarm before it. Quieter when the dashboard starts before the robot,
#   and full marks here. But a heart that had stopped before anybody looked is then never reported.
# - **Publish the alarm on every tick,** changed or not. Then whoever listens can tell "all is well" from "the dashboard is
#   dead", and a lost message does no harm. On change only, with transient local, is quieter. Many robots do both.
# - **`self.get_clock().now()` instead of `time.monotonic()`.** It follows robot time, so the node can be tested at twenty times
#   the speed and works in simulation. On a real robot this clock may be set while it runs; `monotonic` never jumps.
# - **Liveliness.** A policy that tells whether the *program* of the publisher still lives, not whether its messages come.
#   A heart that has stopped in a program that runs on is not noticed by it.
