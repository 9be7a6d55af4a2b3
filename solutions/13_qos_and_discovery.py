# ---
# exercise: 13_qos_and_discovery
# title: The late dashboard
# minutes: 30
# difficulty: 3
# kind: program
# clock: wall
# objectives:
#   - requesting the right QoS for each topic
#   - receiving the last status right away, even if it was published before the program started
#   - detecting that a topic has gone silent, even though no message arrives to trigger a callback
#   - keeping your node's last message available to programs that subscribe later
# out_of_scope:
#   - what the robot should do after an alarm
#   - liveliness and lifespan, and vendor-specific DDS settings
#   - how the program ends on Ctrl-C (lesson 01 judges that)
# ---
# %% [markdown]
# # Exercise 13 · The late dashboard
#
# The night nurse comes on duty and starts the ward robot's dashboard. The robot has been running for hours. It
# published `operational` this morning, and its status hasn't changed since then. The nurse wants to see that status
# *now*. If the robot's heartbeat stops in the middle of the night, the dashboard must raise an alarm within three
# seconds. But it must not raise an alarm for every short delay, or the nurse will soon ignore the alarms. And an alarm
# must not last forever: it must end when the heartbeat resumes.
#
# **About 30 minutes · difficulty 3 of 5 · 10 points.** This exercise builds on lesson [13](../notebooks/13_qos_and_discovery.ipynb).
#
# ## The robot's topics
#
# | topic | type | messages | offered QoS |
# |---|---|---|---|
# | `/robot/status` | `String` | `operational` or `error`, published only when the status changes | reliable, transient local, depth 1, no deadline |
# | `/robot/heartbeat` | `String` | `beat 1`, `beat 2`, …, one every {{BEAT_S}} s | best effort, volatile, deadline 0.5 s |
#
# ## What to build
#
# | topic | type | when | content |
# |---|---|---|---|
# | `/dashboard/line` | `String` | 2 Hz, always | the last status that the dashboard has received, for example `status: error`, or `unknown` until the first one arrives. A line must not contain more than one of the words `operational`, `error`, and `unknown` |
# | `/dashboard/alarm` | `Bool` | at least whenever the alarm changes | whether there is an alarm (see below); the last message is kept for subscriptions created later |
#
# Within {{AT_ONCE_S}} s of the start, the line must show the status that the robot published before your program
# started. A new status must appear within {{FOLLOWS_S}} s of being published.
#
# The alarm is raised (`True`) when no beat has arrived for about 2 s. It must be raised no earlier than
# {{NOT_BEFORE_S}} s and no later than {{NOT_AFTER_S}} s after the last beat. It must stay on until the next beat
# arrives, and then end (`False`) within {{FALLS_WITHIN_S}} s of that beat. Before the first beat, the alarm may have
# either value.
#
# ## What is judged
#
# Your program runs in its own process for fifteen seconds of real time. The judge stands in for the robot. It publishes
# a status before your program starts, and changes the status several times while your program is running. One beat
# comes late, and the heartbeat stops twice, each time for almost four seconds before it resumes.
#
# | points | criterion |
# |---:|---|
# | 1 | `/dashboard/line` exists and carries `String` messages |
# | 1 | the line is published at 2 Hz, even during an alarm |
# | 2 | within {{AT_ONCE_S}} s, the line shows the status that the robot published before your program started |
# | 1 | the line is updated when the status changes |
# | 1 | the program receives the heartbeat |
# | 1 | `/dashboard/alarm` carries `Bool` messages, and the last one is kept for subscriptions created later (reliable, transient local) |
# | 1 | the alarm is raised no later than {{NOT_AFTER_S}} s after the last beat |
# | 1 | the alarm isn't raised too early |
# | 1 | the alarm ends when the heartbeat resumes |
#
# To allow for busy machines, the judge applies these tolerances. A rate of 2 Hz means {{SLOWEST_HZ}} to {{FASTEST_HZ}}
# Hz, with a median interval of {{SHORTEST_S}} to {{LONGEST_S}} s and no gap over {{LONGEST_GAP_S}} s. The start
# or the end of an alarm may come up to {{SLACK_S}} s later than stated above. Your program counts as started once the
# judge has discovered its topics.
#
# **Not judged:**
#
# - the line's content in the first second, and whether you publish a line during that second. (Such a line may still
#   show `unknown`. Later lines must not, because the judge publishes a status before your program starts.)
# - whether you also publish the alarm when it hasn't changed
# - how your program ends
# %% [answer]
"""Show a robot's last status, even after a late start, and raise an alarm when its heartbeat stops."""

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
    """Shows the robot's last status, and raises an alarm when its heartbeat stops."""

    def __init__(self) -> None:
        super().__init__("dashboard")
        self.last_status = "unknown"
        self.line_publisher = self.create_publisher(String, "/dashboard/line", 10)
        # [solution]
        self.last_beat = time.monotonic()  # the silence before the first beat counts, too
        self.alarm: bool | None = None
        self.alarm_publisher = self.create_publisher(Bool, "/dashboard/alarm", STATE_QOS)
        self.create_subscription(String, "/robot/status", self.on_status, STATE_QOS)
        self.create_subscription(String, "/robot/heartbeat", self.on_beat, BEAT_QOS)
        self.create_timer(LOOK_PERIOD_S, self.look_at_the_clock)
        # [starter]
        # | # TODO 1: request earlier messages, too
        # | self.create_subscription(String, "/robot/status", self.on_status, 10)
        # | # TODO 2: subscribe to /robot/heartbeat, and record when the last beat arrived
        # | # TODO 3: publish /dashboard/alarm (Bool), kept for late subscriptions
        # | # TODO 4: detect the silence: what calls your code when no message arrives?
        # [end]
        self.create_timer(LINE_PERIOD_S, self.publish_line)

    def on_status(self, message: String) -> None:
        """Store the status."""
        self.last_status = message.data

    # [solution]
    def on_beat(self, message: String) -> None:
        """Record when the last beat arrived."""
        self.last_beat = time.monotonic()

    def look_at_the_clock(self) -> None:
        """Raise the alarm if the last beat was more than 2 s ago, and end it after a new beat."""
        alarm = time.monotonic() - self.last_beat > LONGEST_SILENCE_S
        if alarm != self.alarm:
            self.alarm = alarm
            self.alarm_publisher.publish(Bool(data=alarm))

    # [end]
    def publish_line(self) -> None:
        """Publish the last status."""
        self.line_publisher.publish(String(data=self.last_status))


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or SIGTERM, then exit with code 0."""
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
# from workbook.ros import topic_echo
#
# %start
# for message in topic_echo("/dashboard/line", count=8, timeout=8.0).messages:  # try /dashboard/alarm, too
#     print(message.data)
# %% [hint]
# There are two topics with two different offers, so you need two QoS profiles. Look at the table *The robot's
# topics*. For each row, decide what you need, and check that the robot offers at least that. A plain `10` requests
# reliable, and it doesn't request earlier messages.
#
# The alarm needs something else. rclpy calls a subscription's callback when a message arrives, but during the
# silence, none arrives. What else in a node can call your code?
#
# All policies with their defaults: [About quality of service
# settings](https://docs.ros.org/en/jazzy/Concepts/Intermediate/About-Quality-of-Service-Settings.html)
# %% [hint]
# - **The earlier status:** Use `QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)` for the subscription.
#   Use the same profile for your alarm's publisher, because other programs may subscribe late, too.
# - **The heartbeat:** Use `reliability=ReliabilityPolicy.BEST_EFFORT`, or `qos_profile_sensor_data`.
# - **The silence:** Use a timer that compares `time.monotonic()` with the time of the last beat, or
#   `SubscriptionEventCallbacks(deadline=...)`. If you request a deadline, it must not be shorter than the offered 0.5
#   s. Its event occurs again and again until the next beat.
# - **The end of the alarm:** There's no event for it. The alarm ends when a beat arrives.
#
# Publishers and subscriptions with their QoS: [rclpy](https://docs.ros.org/en/jazzy/p/rclpy)
# %% [hint]
# Here's the solution with gaps:
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
# `QoSProfile`, `DurabilityPolicy`, and `ReliabilityPolicy` come from `rclpy.qos`. Why later subscriptions need them:
# [About quality of service
# settings](https://docs.ros.org/en/jazzy/Concepts/Intermediate/About-Quality-of-Service-Settings.html)
# %% [alternatives]
# ## Other good ways
#
# - **The deadline event.** Use `QoSProfile(..., deadline=Duration(seconds=2.0))` and
#   `event_callbacks=SubscriptionEventCallbacks(deadline=self.on_missed)`. The middleware measures the time, so your
#   node needs no clock. But the publisher must offer a deadline. If it doesn't, you receive nothing at all, and only
#   one line in the log tells you so. Also, DDS measures the deadline only from the first message.
# - **A timer that is reset.** Create `self.watchdog = self.create_timer(2.0, self.on_silence)`, and call
#   `self.watchdog.reset()` at every beat. The timer fires only if it hasn't been reset for 2 s. This is short and
#   clear. It also fires if there was never a beat.
# - **`last_beat = None` until the first beat,** and no alarm before it. A dashboard that starts before the robot then
#   raises no alarm. This gets full credit here. But if the heartbeat stopped before the dashboard started, the
#   dashboard never reports that.
# - **Publish the alarm on every tick,** even if it hasn't changed. Then a subscriber can distinguish "all is well"
#   from "the dashboard is dead", and a lost message does no harm. Publishing only changes, with transient local,
#   needs fewer messages. Many robots do both.
# - **`self.get_clock().now()` instead of `time.monotonic()`.** The node's clock follows simulated time, so the node
#   works in simulation, and you can test it at twenty times real-time speed. On a real robot, this clock may be
#   adjusted while the node runs, but `time.monotonic()` never jumps.
# - **Liveliness.** This policy reports whether the publisher's *program* is still running, not whether its messages
#   arrive. So it doesn't detect a heartbeat that stops in a running program.
