# %% [markdown]
# # 13 · QoS and discovery
#
# A dashboard is switched on hours after the robot. What does it hear of the robot, and what does that depend on?
#
# - **Minutes:** 45
# - **You need:** lessons [03](03_publishers_and_messages.ipynb) to 05: publishers, subscriptions, timers
# - **You will be able to:**
#   - say what decides whether a subscription gets a message
#   - say what a program gets that starts late
#   - use a deadline, or a timer that checks the clock
# - **Left out:** liveliness, lifespan and history (three more policies), discovery servers, settings that only one
#   DDS implementation has

# %% [markdown]
# This robot publishes its status once, when it starts. Its heart beats four times a second. We record it for five
# seconds. In the film, the robot moves a little at each beat that arrived.

# %%
from lesson_nodes import heartbeat, status_monitor
from workbook.lesson import arrivals, graph_picture, record, start, stop
from workbook.pictures.moving import Robot, robots

BEAT = "/robot/heartbeat"
film = record(
    heartbeat, {BEAT: 0.25}, seconds=5, clock="wall", beats_for_s=2.0, silent_for_s=2.0
)
robots(
    [Robot("the robot", arrivals(film, BEAT), period=0.25, trouble="silent")],
    "a robot moves for two seconds, stands still with a red lamp, then moves again",
    end=5.0,
)

# %% [markdown]
# For two seconds the heart was silent. The program did not crash, and nothing was logged. Who notices? First, how does
# a listener find this robot at all?

# %%
print("started", start(heartbeat))
print("started", start(status_monitor))
graph_picture()

# %% [markdown]
# The monitor's code contains no address, no port and no server. Each program announces itself on the network when it
# starts. The others reply with what they publish and what they subscribe to. This is called **discovery**. DDS does it,
# the layer below ROS.
#
# The picture draws an arrow where two topic names are equal.

# %%
stop()

# %% [markdown] prediction="eight-beats"
# ## Predict
#
# The robot publishes its heartbeat like this. A lost beat does no harm, because the next one comes soon:
#
# ```python
# BEAT_QOS = QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT, ...)
# self.beat_publisher = self.create_publisher(String, "/robot/heartbeat", BEAT_QOS)
# ```
#
# A monitor subscribes as you have always done it:
#
# ```python
# self.create_subscription(String, "/robot/heartbeat", self.on_beat, 10)
# ```
#
# Same topic, same type. The robot sends eight beats. What does the monitor get?
#
# - **a** All eight: the topic and the type are right.
#   when `heard == 8`
#   ✗ Topic and type are right, but not the reliability. The monitor asks for reliable, and the robot offers less.
# - **b** Most of them: best effort may lose some.
#   when `0 < heard < 8`
#   ✗ Best effort can lose messages between two sides that are matched. These two are not matched at all.
# - **c** Nothing, and both sides log a warning.
#   when `heard == 0 and matched == 0`
#   ✓ `10` requests reliable, and best effort is offered. DDS does not match the two, and rclpy logs a warning on both
#   sides.
# - **d** An exception: the two do not fit.
#   ✗ Neither side gets an exception. Publisher and subscription are made as if all were well.
# - **e** Nothing, and nothing is logged anywhere.
#   ✗ Nothing arrives, but it is logged: each side gets a warning.

# %%
from workbook.lesson import predict, reveal

predict("eight-beats")

# %% [markdown]
# ## Run it
#
# Now both nodes live in this notebook, so that we can inspect them. First the robot runs for eight beats. Messages that
# have arrived by then wait in the monitor's queue. Then the monitor runs.

# %%
from lesson_nodes.heartbeat import Heartbeat
from rclpy.node import Node
from std_msgs.msg import String

from workbook.lesson import fresh, init, run

init()


class Monitor(Node):
    """Keeps the heartbeats that arrive."""

    def __init__(self, qos) -> None:
        super().__init__("monitor")
        self.heard: list[str] = []
        self.create_subscription(String, "/robot/heartbeat", self.on_beat, qos)

    def on_beat(self, message: String) -> None:
        self.heard.append(message.data)


# %% id="eight-beats"
robot, monitor = fresh(Heartbeat), fresh(Monitor, 10)
await run(robot, seconds=20, until=lambda: robot.beats == 8)
await run(monitor, seconds=1.0)
print("sent: ", robot.beats)
print("heard:", len(monitor.heard))

# %%
matched = robot.beat_publisher.get_subscription_count()
print("subscriptions that the robot counts:", matched)
reveal("eight-beats", heard=len(monitor.heard), matched=matched)

# %% [markdown]
# ## Look inside
#
# Every publisher and every subscription has a **QoS profile** (quality of service): a set of **policies**. The publisher
# says what it **offers**. The subscription says what it **requests**. DDS *matches* the two only if each offer is at
# least as good as the request. The arrow in the picture of the graph does not show this: it compares only names.
#
# The robot offered best effort, and the monitor requested reliable. `10` is short for `QoSProfile(depth=10)`. Everything
# that you leave out has a default:

# %%
from rclpy.qos import QoSProfile, qos_profile_sensor_data

for name, profile in (
    ("10", QoSProfile(depth=10)),
    ("qos_profile_sensor_data", qos_profile_sensor_data),
):
    print(f"{name:<24}{profile.reliability.name}, {profile.durability.name}")

# %% [markdown]
# | policy | lower | higher | what the lower one means / what the higher one means |
# |---|---|---|---|
# | reliability | `BEST_EFFORT` | `RELIABLE` | each message is sent once / it is sent again until it has arrived, as long as it is one of the last `depth` |
# | durability | `VOLATILE` | `TRANSIENT_LOCAL` | messages are only sent / messages are also kept for later |
# | deadline | none | short | no promise / no more than this time between two messages |
#
# `depth` is not in the table. It is the length of one side's own queue, and it is not compared.
#
# You can ask rclpy whether two profiles fit. The first argument is the offer, the second is the request:

# %% id="ask-rclpy"
from lesson_nodes.heartbeat import BEAT_QOS
from rclpy.qos import qos_check_compatible

verdict, reason = qos_check_compatible(BEAT_QOS, QoSProfile(depth=10))
print(verdict.name)
print(reason)

# %% [markdown]
# On a running robot you do not have the profiles in your code, but each node announces its own. `topic_info` collects
# them and asks rclpy for every pair. With a ROS installation, `ros2 topic info -v` lists them.

# %% id="topic-info"
from workbook.ros import topic_info

for problem in topic_info("/robot/heartbeat").problems:
    print(problem)

# %% [markdown]
# Here is the fix. The subscription requests less:

# %%
monitor = fresh(Monitor, qos_profile_sensor_data)
await run(robot, monitor, seconds=20, until=lambda: len(monitor.heard) == 8)
print("heard:", len(monitor.heard))

# %% [markdown]
# Two common beliefs are wrong.
#
# - *"QoS must be equal on both sides."* The offer must be at least as good as the request. A reliable publisher and a
#   best effort subscription match.
# - *"DDS does not report a mismatch."* It does: you read `requesting incompatible QoS` and `offering incompatible QoS`
#   above. But each is one line in a log, it comes once, and only while the node is spun.

# %% [markdown] prediction="late-dashboard"
# ## Change it
#
# ### Experiment 1: the late dashboard
#
# A robot publishes three words when it starts, and then no more: `booting`, `standing`, `operational`. Its publisher is
# transient local with `depth=1`. Later, two dashboards open. The *plain* one subscribes with `10`. The *latched* one
# requests transient local, with `depth=10`. What do they know about the robot?
#
# - **a** The plain one knows nothing, the latched one `operational`.
#   when `plain_knows == 0 and latched_knows == 1`
#   ✓ Only the latched one requests earlier messages. With `depth=1` the publisher keeps one message, the last one.
# - **b** Both know `operational`: it is the last word that was published.
#   when `plain_knows == 1 and latched_knows == 1`
#   ✗ A volatile subscription gets only messages from after the match. There were none.
# - **c** Neither knows anything: nothing was published since they opened.
#   when `plain_knows == 0 and latched_knows == 0`
#   ✗ The publisher is transient local: it keeps its last message for subscriptions that request it.
# - **d** The plain one knows nothing, the latched one all three.
#   when `plain_knows == 0 and latched_knows == 3`
#   ✗ The publisher's depth decides how much is kept, and that is 1. The subscription's depth does not matter here.

# %%
predict("late-dashboard")

# %% id="late-dashboard"
from lesson_nodes import early_speaker
from rclpy.qos import DurabilityPolicy

LATCHED = QoSProfile(depth=10, durability=DurabilityPolicy.TRANSIENT_LOCAL)


class Dashboard(Node):
    """Keeps the status words that arrive."""

    def __init__(self, name: str, qos) -> None:
        super().__init__(name)
        self.known: list[str] = []
        self.create_subscription(String, "/robot/status", self.on_status, qos)

    def on_status(self, message: String) -> None:
        self.known.append(message.data)


robot.destroy_node()  # it publishes a status, too
start(early_speaker, depth=1)
plain, latched = fresh(Dashboard, "plain", 10), fresh(Dashboard, "latched", LATCHED)
await run(plain, latched, seconds=6)
print("plain:  ", plain.known)
print("latched:", latched.known)
reveal("late-dashboard", plain_knows=len(plain.known), latched_knows=len(latched.known))

# %% [markdown]
# The *publisher* keeps its last messages, as many as its depth. It hands them to each new subscription that requests
# them. In ROS 1 such a topic was called **latched**. Both sides must be transient local, and both must be reliable.
#
# How many does the robot keep? Change the depth of its publisher:

# %%
for depth in (1, 2, 3):
    start(early_speaker, depth=depth)
    late = fresh(Dashboard, "late", LATCHED)
    await run(late, seconds=10, until=lambda known=late.known: "operational" in known)
    print(f"depth {depth}:", ", ".join(late.known))
stop()

# %% [markdown]
# For a *state* (status, map, robot description) depth 1 is right: only the last one is true. A *stream* (camera,
# heartbeat) stays volatile: an old heartbeat says nothing about the robot now.

# %% [markdown] prediction="the-silence"
# ### Experiment 2: when a publisher goes silent
#
# The last line of the table is the **deadline**. The robot offers at most 0.5 s between two beats. A watcher requests
# at most 1.0 s. That is less strict than the offer, so they match. The watcher also gives a callback for the event that
# the deadline was missed:
#
# ```python
# SubscriptionEventCallbacks(deadline=self.on_missed)
# ```
#
# The heart beats for 2 s, and then it is silent for two and a half seconds. How often is `on_missed` called?
#
# - **a** Never: no message, no callback.
#   when `missed == 0`
#   ✗ There is no message, but there is an event: DDS measures the time since the last message and reports when it exceeds
#   the deadline.
# - **b** Once, one second after the last beat.
#   when `missed == 1`
#   ✗ After a missed deadline, DDS starts to count anew, and reports again when the next period is over.
# - **c** Four times a second, once for each beat that is missing.
#   when `missed > 6`
#   ✗ Beats are due four times a second, but the watcher has not asked for that. Its deadline is 1.0 s.
# - **d** Again and again, once in each second of silence.
#   when `1 < missed <= 6`
#   ✓ The deadline that counts is the one that the watcher requested, 1.0 s. It is missed once in each second of
#   silence.

# %%
predict("the-silence")

# %%
import time
from itertools import pairwise

from rclpy.duration import Duration
from rclpy.event_handler import SubscriptionEventCallbacks
from rclpy.qos import ReliabilityPolicy


class Watcher(Node):
    """Notes each beat, and each missed deadline."""

    def __init__(self, deadline_s: float) -> None:
        super().__init__("watcher")
        self.began = time.monotonic()
        self.beats: list[float] = []
        self.missed: list[float] = []
        self.create_subscription(
            String,
            "/robot/heartbeat",
            self.on_beat,
            QoSProfile(
                depth=5,
                reliability=ReliabilityPolicy.BEST_EFFORT,
                deadline=Duration(seconds=deadline_s),
            ),
            event_callbacks=SubscriptionEventCallbacks(deadline=self.on_missed),
        )

    def on_beat(self, message: String) -> None:
        self.beats.append(time.monotonic() - self.began)

    def on_missed(self, event) -> None:
        self.missed.append(time.monotonic() - self.began)


def is_over() -> bool:
    """Whether four beats have come after a silence of more than two seconds."""
    return any(b - a > 2.0 for a, b in pairwise(watcher.beats[:-3]))


robot = fresh(Heartbeat, beats_for_s=2.0, silent_for_s=2.25)
watcher = fresh(Watcher, 1.0)
await run(robot, watcher, seconds=20, until=is_over)
reveal("the-silence", missed=len(watcher.missed))

# %%
from workbook.pictures.moving import played_back
from workbook.pictures.palette import AMBER
from workbook.pictures.timeline import Row

played_back(
    [
        Row("heartbeat", watcher.beats, period=0.25, start=0.0),
        Row("deadline missed", watcher.missed, color=AMBER),
    ],
    "heartbeats, then a silence: the missed deadline is reported "
    "after one second and again after two",
    end=watcher.beats[-1],
)

# %%
last_before = max(t for t in watcher.beats if t < watcher.missed[0])
waits = [moment - last_before for moment in watcher.missed]
print("missed more than once in one silence:", len(watcher.missed) > 1)
print("the first event came after about 1 s:", 0.9 < waits[0] < 1.9)
print("all events in the silence:", all(t < watcher.beats[-1] for t in watcher.missed))

# %% [markdown]
# The event comes when the deadline has passed, and again after each further period, until the next message. Two limits:
#
# - The time counts from the last message. Before the first message there is no event.
# - No event says that messages are back. You see that in `on_beat`.
#
# A timer that checks the clock does the same. It needs a little more code, and no promise from the publisher.

# %% [markdown]
# ## When it goes wrong
#
# **A deadline that is not offered.** Our robot publishes its status without a deadline. This node requests one. The robot
# then publishes a status. Does it arrive?


# %% id="deadline-not-offered"
class Impatient(Node):
    """Requests a status at least once a second."""

    def __init__(self) -> None:
        super().__init__("impatient")
        self.heard: list[str] = []
        wish = QoSProfile(depth=1, deadline=Duration(seconds=1.0))
        self.subscription = self.create_subscription(
            String, "/robot/status", self.on_status, wish
        )

    def on_status(self, message: String) -> None:
        self.heard.append(message.data)


impatient = fresh(Impatient)
await run(impatient, seconds=1.0)
robot.status_publisher.publish(String(data="error"))
await run(impatient, seconds=1.0)
print("heard:", impatient.heard)
print("publishers that it has found:", impatient.subscription.get_publisher_count())

# %% [markdown]
# Nothing arrived. A deadline is a request like the others: if it is not offered, there is no match. The warning names
# the policy at its end: `DEADLINE`. Offer it on the publisher, or do not request it and check the clock with a timer.

# %% [markdown]
# **The same topic, another type.** In its own process, the robot publishes text. This node subscribes with `Float32`:

# %% id="other-type-silence"
from std_msgs.msg import Float32

from workbook.ros import shutdown

shutdown()  # a fresh start: within one process, a second type is refused
init()


class Deaf(Node):
    """Subscribes with the wrong type."""

    def __init__(self) -> None:
        super().__init__("deaf")
        self.heard: list[float] = []
        self.create_subscription(
            Float32, "/robot/heartbeat", self.on_number, qos_profile_sensor_data
        )

    def on_number(self, message: Float32) -> None:
        self.heard.append(message.data)


start(heartbeat)
deaf = fresh(Deaf)
await run(deaf, seconds=2.0)
print("heard:", deaf.heard)
print(*topic_info("/robot/heartbeat").problems)
stop()

# %% [markdown]
# No number, no exception, and with Fast DDS no warning either. If a topic is silent and nothing is logged, compare the
# *types*: with `topic_info` here, with `ros2 topic info -v` on a robot. Give the number a name of its own, such as
# `/robot/beat_count`.

# %% [markdown]
# ## From a worked example to your own
#
# **Worked.** A panel beside the lab's entrance may be switched on at any time. It needs the last status at once, so it
# requests what the robot offers: transient local. Others may subscribe to the panel later, so it offers the same.

# %%
STATE = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)


class Panel(Node):
    """Shows the last status, and publishes whether you may enter."""

    def __init__(self) -> None:
        super().__init__("panel")
        self.line = "unknown"
        self.create_subscription(String, "/robot/status", self.on_status, STATE)
        self.sign = self.create_publisher(String, "/panel/sign", STATE)

    def on_status(self, message: String) -> None:
        self.line = message.data
        word = "come in" if message.data == "operational" else "keep out"
        self.sign.publish(String(data=word))


# The heart of this robot pauses. The next cells use it.
start(heartbeat, beats_for_s=3.0, silent_for_s=5.0)
panel = fresh(Panel)
await run(panel, seconds=10, until=lambda: panel.line != "unknown")
print("the panel knows:", panel.line)

# %%
late = fresh(Node, "late")
signs = []
late.create_subscription(
    String, "/panel/sign", lambda message: signs.append(message.data), STATE
)
await run(late, seconds=10, until=lambda: signs)
print("a late listener reads:", signs[-1])

# %% [markdown]
# **Faded.** The panel also has to raise an alarm when the heart has been silent for more than 2 s. A timer checks the
# clock. Fill in what is `...`. Until then the cell runs, and prints what is missing.

# %%
LIMIT_S = ...  # TODO: seconds of silence that are too long


class AlarmPanel(Panel):
    """Raises an alarm when the heart is silent."""

    def __init__(self) -> None:
        super().__init__()
        self.alarms: list[bool] = []
        self.beats = 0
        self.last_beat = time.monotonic()  # no beat yet: count the silence from here
        # TODO: subscribe to /robot/heartbeat with a QoS that fits;
        # the callback is self.on_beat.
        self.create_timer(0.25, self.check_the_clock)

    def on_beat(self, message: String) -> None:
        self.beats += 1
        self.last_beat = time.monotonic()

    def check_the_clock(self) -> None:
        silent_s = time.monotonic() - self.last_beat
        self.alarms.append(silent_s > LIMIT_S)


if LIMIT_S is ...:
    print("Fill in the limit and the subscription, then run this cell again.")
else:
    alarm_panel = fresh(AlarmPanel)
    await run(alarm_panel, seconds=9)
    beats, alarms = alarm_panel.beats, alarm_panel.alarms
    print("beats heard:", beats or "none: check the subscription and its QoS")
    print("alarm:", alarms.count(True), "times; no alarm:", alarms.count(False))

# %%
stop()

# %% [markdown]
# **Your own.** In the [exercise](../exercises/13_qos_and_discovery.ipynb) you build a dashboard that starts late. It knows
# the last status at once, and raises an alarm within three seconds when the heart of the robot goes silent.

# %% [markdown]
# ## Check yourself
#
# **1. A camera publishes with best effort. Your node subscribes with `10` and hears nothing. What do you change?**
#
# <details><summary>a) The reliability of your subscription, to best effort</summary>
#
# ✓ Yes. `10` requests reliable, and that is more than is offered. `qos_profile_sensor_data` is made for this.
#
# </details>
# <details><summary>b) The depth: 10 is too small for pictures</summary>
#
# ✗ The depth is your own queue. It is not compared with anything.
#
# </details>
# <details><summary>c) The durability of your subscription, to transient local</summary>
#
# ✗ Then you request two things that are not offered.
#
# </details>
#
# **2. A publisher offers reliable and transient local. A subscription requests best effort and volatile. What arrives?**
#
# <details><summary>a) Nothing, because the profiles differ</summary>
#
# ✗ They may differ. Each offer has to be at least as good as the request, and here both are better.
#
# </details>
# <details><summary>b) Every message from the match on</summary>
#
# ✓ Yes. The two match, and nothing from before was requested.
#
# </details>
# <details><summary>c) Every message from the match on, and the last one from before</summary>
#
# ✗ The publisher hands earlier messages only to subscriptions that request transient local.
#
# </details>
#
# **3. The map is published once, volatile. Your late node requests transient local. What does it get?**
#
# <details><summary>a) The map: your side asked for it</summary>
#
# ✗ The publisher has to keep it as well. A volatile publisher keeps nothing for late subscriptions.
#
# </details>
# <details><summary>b) Nothing now, but the next map</summary>
#
# ✗ Not even that: volatile is less than transient local, so the two do not match.
#
# </details>
# <details><summary>c) Nothing, and no later map either: they do not match</summary>
#
# ✓ Yes, and a warning names the policy, `DURABILITY`.
#
# </details>
#
# **4. You request a deadline of 2 s, and the robot is still switched off. When does `on_missed` run first?**
#
# <details><summary>a) After the first message, as soon as 2 s pass without another one</summary>
#
# ✓ Before the first message there is no event. A timer that shows `unknown` covers that time.
#
# </details>
# <details><summary>b) 2 s after the subscription was made</summary>
#
# ✗ The time counts from a message. There has not been one.
#
# </details>
# <details><summary>c) As soon as the robot is switched on</summary>
#
# ✗ Then the first message comes, so no deadline is missed.
#
# </details>
#
# **5. `topic_info` lists publisher and subscriber, nothing is logged, and nothing arrives. What do you check first?**
#
# <details><summary>a) The domain</summary>
#
# ✗ If the domains differed, you would not see both in one list.
#
# </details>
# <details><summary>b) The types</summary>
#
# ✓ A QoS mismatch is logged. A type mismatch between two processes is not, with Fast DDS. Then check that the node is
# spun.
#
# </details>
# <details><summary>c) The network cable</summary>
#
# ✗ Without a network they would not have found each other, and the list would be empty.
#
# </details>

# %% [markdown]
# ## Talk it through
#
# Copy the prompt for an AI assistant, or discuss it with a colleague. State your own view first.
#
# ```text
# I program a robot with ROS 2 Jazzy in Python (rclpy). My robot publishes a laser scan
# at 20 Hz, a map that changes every few minutes, and an emergency stop. A tablet joins
# and leaves over bad wireless. Which reliability, durability, depth and deadline would
# you give to each topic, on both sides, and how does the tablet notice that it has lost
# the robot? Name only functions that exist in rclpy for Jazzy.
# ```
#
# <details><summary>What a good answer contains</summary>
#
# **The scan:** best effort, volatile, a small depth. A scan that is sent again is old when it arrives, and the repeats
# fill the channel. **The map:** reliable, transient local, depth 1 on the publisher, and requested by the tablet.
# **The emergency stop:** reliable is not enough, because a stop that does not arrive stops nothing. Turn it around: the
# tablet sends "go on" as a heartbeat, and the robot stops when that goes silent. **The loss:** a deadline on the scan,
# offered by the robot, or a timer that checks the clock. The tablet should show how old its data are. Good answers say
# that a deadline counts from the first message only, and that you test all this by pulling the plug.
#
# </details>
#
# <details><summary>What to check in the reply</summary>
#
# Two claims you may meet. Both are wrong: each was tried with the rclpy of this course.
#
# - **`QoSProfile(depth=10, deadline=0.1)`:** A plain number of seconds is not accepted. It must be
#   `Duration(seconds=0.1)`.
# - **A best-effort subscriber does not match a reliable publisher:** In fact, it does match, because it asks for less
#   than is offered. The other way around does not match.
#
# </details>

# %% [markdown]
# ## Take away
#
# - A publisher offers, a subscription requests. They match if each offer is at least as good as the request.
# - A mismatch is one line in the log of both sides, and then silence. `qos_check_compatible` and `topic_info` say why.
# - Transient local on both sides: a late subscription gets the last `depth` messages at once. Use it for states.
# - A deadline has to be offered to be requested. A timer that checks the clock needs no offer.
# - If two sides are listed and nothing arrives or is logged, compare the types.
#
# **Before:** [12 · Services](12_services.ipynb)
#
# **Deeper:** [13 · Deeper: discovery and the first messages](13_qos_and_discovery_deeper.ipynb)
#
# **Next:** [14 · Arrays and filters](14_arrays_and_filters.ipynb)
#
# **More:** [About quality of service settings](https://docs.ros.org/en/jazzy/Concepts/Intermediate/About-Quality-of-Service-Settings.html),
# with all policies, and [About discovery](https://docs.ros.org/en/jazzy/Concepts/Basic/About-Discovery.html).
