# %% [markdown]
# # 13 · QoS and discovery
#
# A dashboard starts hours after the robot. Which of the robot's earlier messages does it still receive, and why does it
# miss the others? And how does it notice that the robot has gone silent?
#
# - **Minutes:** 50
# - **You need:** lessons [03](03_publishers_and_messages.ipynb) to 05: publishers, subscriptions, timers
# - **You will be able to:**
#   - explain why a subscription receives a message, or why it doesn't
#   - predict which messages reach a program that starts late
#   - detect silence, either with a deadline or by checking the age of the last message
# - **Not covered:** three more policies (liveliness, lifespan, and history), discovery servers, and vendor-specific DDS
#   settings

# %% [markdown]
# This robot publishes its status once, when it starts, and a heartbeat four times per second. We record it for five
# seconds. In the animation, the robot moves a little whenever a beat arrives.

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
# The heartbeat stopped for two seconds, but the program didn't crash, and it logged nothing. So how can another program
# notice the silence? Before we answer that, let's see how a subscriber finds this robot in the first place.

# %%
print("started", start(heartbeat))
print("started", start(status_monitor))
graph_picture()

# %% [markdown]
# The monitor's code doesn't name an address, a port, or a server. Instead, each program announces itself on the network
# when it starts. The other programs reply with lists of their publishers and subscriptions. This process is called
# **discovery**, and DDS, the layer below ROS, takes care of it.
#
# In the figure, arrows connect each node to the topics that it publishes to or subscribes to.

# %%
stop()

# %% [markdown] prediction="eight-beats"
# ## Predict
#
# Losing a heartbeat does no harm, because the next one follows soon. So the robot publishes its heartbeat with
# best-effort reliability, which means that a lost message isn't sent again:
#
# ```python
# BEAT_QOS = QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT, ...)
# self.beat_publisher = self.create_publisher(String, "/robot/heartbeat", BEAT_QOS)
# ```
#
# A monitor subscribes as you did in lesson 04:
#
# ```python
# self.create_subscription(String, "/robot/heartbeat", self.on_beat, 10)
# ```
#
# Both sides use the same topic and the same type. The robot publishes eight beats. What does the monitor receive?
#
# - **a** All eight, because the topic and the type match.
#   when `heard == 8`
#   ✗ The topic and the type do match, but the reliability doesn't. The monitor requests reliable delivery, but the
#   robot offers only best effort.
# - **b** Most of them, because best effort may lose some.
#   when `0 < heard < 8`
#   ✗ A best-effort publisher can lose messages only to a matched subscription. Here, DDS doesn't match the two at all.
# - **c** Nothing, and both sides log a warning.
#   when `heard == 0 and matched == 0`
#   ✓ `10` requests reliable delivery, but the robot offers best effort. So DDS doesn't match the two, and rclpy logs a
#   warning on both sides.
# - **d** An exception, because the QoS settings are incompatible.
#   ✗ Neither side gets an exception. rclpy creates the publisher and the subscription as usual.
# - **e** Nothing, and neither side logs anything.
#   ✗ Nothing arrives, but each side logs a warning.

# %%
from workbook.lesson import predict, reveal

predict("eight-beats")

# %% [markdown]
# ## Run it
#
# This time, both nodes run in the notebook, so we can inspect them. First, only the robot runs, for eight beats. If
# messages arrive, they stay in the monitor's queue until we run the monitor as well.
#
# [the same without helpers: start, record, init, fresh, run]

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
# Every publisher and every subscription has a **QoS profile** (QoS stands for *quality of service*), which is a set of
# **policies**. The publisher **offers** its profile, and the subscription **requests** one. DDS compares the two
# profiles policy by policy. It *matches* the two sides only if every offered policy is at least as good as the
# requested one. The figure above doesn't show whether two sides match, because its arrows depend only on topic names.
#
# The robot offered best effort, but the monitor requested reliable delivery, because it passed just `10`, which is
# short for `QoSProfile(depth=10)`. In that profile, all other policies have their default values. The next cell prints
# two of that profile's policies, and then the same two policies for a predefined profile:

# %%
from rclpy.qos import QoSProfile, qos_profile_sensor_data


def policies(profile) -> str:
    """The reliability and the durability of a profile."""
    return f"{profile.reliability.name}, {profile.durability.name}"


print("10:                     ", policies(QoSProfile(depth=10)))
print("qos_profile_sensor_data:", policies(qos_profile_sensor_data))

# %% [markdown]
# | policy | weaker value | stronger value |
# |---|---|---|---|
# | reliability | `BEST_EFFORT`: each message is sent only once | `RELIABLE`: a message is sent again until it arrives, unless `depth` newer messages have replaced it |
# | durability | `VOLATILE`: no messages are kept for later subscriptions | `TRANSIENT_LOCAL`: the last `depth` messages are kept for later subscriptions |
# | deadline | none, or a longer time | a shorter time: consecutive messages are never farther apart than this |
#
# The table leaves out `depth`, the length of the queue on each side, because DDS doesn't compare depths.
#
# rclpy can tell you whether two profiles are compatible. Pass the offer as the first argument and the request as the
# second:

# %% id="ask-rclpy"
from lesson_nodes.heartbeat import BEAT_QOS
from rclpy.qos import qos_check_compatible

verdict, reason = qos_check_compatible(BEAT_QOS, QoSProfile(depth=10))
print(verdict.name)
print(reason)

# %% [markdown]
# On a real robot, most profiles are set in other people's code. But each node announces its profiles, so `topic_info`
# can collect them and check each pair for compatibility. In a ROS installation, `ros2 topic info -v` lists the
# profiles.

# %% id="topic-info"
from workbook.ros import topic_info

for problem in topic_info("/robot/heartbeat").problems:
    print(problem)

# %% [markdown]
# To fix the problem, make the subscription request less:

# %%
monitor = fresh(Monitor, qos_profile_sensor_data)
await run(robot, monitor, seconds=20, until=lambda: len(monitor.heard) == 8)
print("heard:", len(monitor.heard))

# %% [markdown]
# **Your turn.** A camera offers best-effort reliability and volatile durability. A viewer needs only the newest image.
# Write the profile for the viewer's subscription, with `depth`, `reliability`, and no other policy.

# %% id="your-camera"
from rclpy.qos import ReliabilityPolicy

from workbook.lesson import yours

viewer = ...  # TODO: a QoSProfile

seen = viewer if viewer is ... else (viewer.depth, policies(viewer))
yours(
    seen,
    (1, "BEST_EFFORT, VOLATILE"),
    "QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)",
)

# %% [markdown]
# Two common beliefs about QoS are wrong.
#
# - *"Both sides must have the same QoS."* The offer only has to be at least as good as the request. So a reliable
#   publisher matches a best-effort subscription.
# - *"DDS doesn't report a mismatch."* It does: `requesting incompatible QoS` and `offering incompatible QoS` appear in
#   the log above. But each side logs only one line per mismatch. That line appears only after discovery, and only while
#   the node on that side is spinning.

# %% [markdown] prediction="late-dashboard"
# ## Change it
#
# ### Experiment 1: the late dashboard
#
# When a robot starts, it publishes three words, `booting`, `standing`, and `operational`, and then nothing more. Its
# publisher is transient local with `depth=1`. Two dashboards start later. One, called *plain*, subscribes with just
# `10`, as usual. The other, called *latched*, requests transient local with `depth=10`. Which of the words does each
# dashboard receive?
#
# - **a** The plain one receives nothing, and the latched one receives `operational`.
#   when `plain_knows == 0 and latched_knows == 1`
#   ✓ Only the latched dashboard requests earlier messages. With `depth=1`, the publisher keeps only the last one.
# - **b** Both receive `operational`, the last word.
#   when `plain_knows == 1 and latched_knows == 1`
#   ✗ A volatile subscription receives only messages published after the match, and there were none.
# - **c** Neither receives anything, because nothing has been published since they started.
#   when `plain_knows == 0 and latched_knows == 0`
#   ✗ The publisher is transient local, so it keeps its last message for subscriptions that request it.
# - **d** The plain one receives nothing, and the latched one receives all three words.
#   when `plain_knows == 0 and latched_knows == 3`
#   ✗ The publisher's depth of 1 determines how many messages it keeps. The subscription's depth doesn't change that.

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
# The *publisher* stores as many of its last messages as its depth allows. It sends them to every new subscription
# that requests them. ROS 1 called such a topic **latched**. With Fast DDS, this works only if both sides are transient
# local and reliable.
#
# What if the publisher stores more than one message? Let's change its depth:

# %%
for depth in (1, 2, 3):
    start(early_speaker, depth=depth)
    late = fresh(Dashboard, "late", LATCHED)
    await run(late, seconds=10, until=lambda known=late.known: "operational" in known)
    print(f"depth {depth}:", ", ".join(late.known))
stop()

# %% [markdown]
# For a *state*, such as a status, a map, or a robot description, use a depth of 1, because only the latest value is
# valid. A *stream*, such as camera images or a heartbeat, should stay volatile. An old heartbeat tells you nothing
# about the robot's current state.
#
# **Your turn.** A map is published again only when it changes. Write one profile for both sides, so that even a program
# that starts late receives the newest map.

# %% id="your-map"
map_qos = ...  # TODO: a QoSProfile

seen = map_qos if map_qos is ... else (map_qos.depth, policies(map_qos))
yours(
    seen,
    (1, "RELIABLE, TRANSIENT_LOCAL"),
    "QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)",
)

# %% [markdown] prediction="the-silence"
# ### Experiment 2: when a publisher goes silent
#
# The third policy in the table above is the **deadline**. The robot promises at most 0.5 s between two beats. A watcher
# requests at most 1.0 s, which is less strict, so the two match. The watcher also passes a callback for missed
# deadlines:
#
# ```python
# SubscriptionEventCallbacks(deadline=self.on_missed)
# ```
#
# The robot publishes beats for 2 s and is then silent for 2.5 s. How many times is `on_missed` called?
#
# - **a** Never, because a callback runs only when a message arrives.
#   when `missed == 0`
#   ✗ No message arrives, but an event does: DDS measures the time since the last message and reports when it exceeds
#   the deadline.
# - **b** Once, one second after the last beat.
#   when `missed == 1`
#   ✗ After each missed deadline, DDS restarts its clock. It reports again if another second passes without a message.
# - **c** Four times a second, once for each missing beat.
#   when `missed > 6`
#   ✗ A beat is due every 0.25 s, but the watcher's deadline is 1.0 s, so DDS reports only once a second.
# - **d** Again and again, once per second of silence.
#   when `1 < missed <= 6`
#   ✓ DDS checks the watcher's requested deadline of 1.0 s. The silence exceeds it once per second.

# %%
predict("the-silence")

# %%
import time
from itertools import pairwise

from rclpy.duration import Duration
from rclpy.event_handler import SubscriptionEventCallbacks


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
from workbook.lesson import about

last_before = max(t for t in watcher.beats if t < watcher.missed[0])
first_after = min(t for t in watcher.beats if t > watcher.missed[0])
after_s = [moment - last_before for moment in (*watcher.missed[:2], first_after)]
print("missed deadlines:", about(len(watcher.missed), between=(2, 4), digits=1))
print("first event: ", about(after_s[0], "s after the last beat", between=(0.9, 1.9)))
print("second event:", about(after_s[1], "s after the last beat", between=(1.9, 2.9)))
print("next beat:   ", about(after_s[2], "s after the last beat", between=(2.1, 5)))

# %% [markdown]
# The missed-deadline event occurs when the deadline passes, and again after each further second without a message.
# Deadlines have two limitations:
#
# - DDS measures the time from the last message, so there's no event before the first message.
# - No event reports that messages are arriving again. Your code can detect that only in `on_beat`.
#
# You can also detect the silence with a timer whose callback checks the age of the last message. That takes a little
# more code, but the publisher doesn't have to offer a deadline.
#
# **Your turn.** The robot offers a deadline of 0.5 s. Which of these requests match that offer: 0.2, 0.5, 1.0, or 3.0 s?

# %% id="your-deadline"
matching = ...  # TODO: a list of numbers

yours(matching, [0.5, 1.0, 3.0], "The offer must be at least as strict as the request.")

# %% [markdown]
# ## When it goes wrong
#
# **Requesting a deadline that isn't offered.** The robot's status publisher offers no deadline, but this node requests
# one. Then the robot publishes a status. Does the node receive it?


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
# The status didn't arrive. Deadlines work like the other policies in the table: if you request one, the publisher has
# to offer one. Otherwise, DDS doesn't match the two sides. The warning in the log ends with the policy's name,
# `DEADLINE`. To fix this, make the publisher offer a deadline. Or drop the request, and use a timer to check the age of
# the last message instead.

# %% [markdown]
# **Same topic, different types.** The robot runs in its own process and publishes text. This node subscribes to the
# same topic, but with the type `Float32`:

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
deaf.destroy_node()  # this process may now subscribe to the topic as text again
stop()

# %% [markdown]
# The node doesn't receive any numbers, and there's no exception. With Fast DDS, there's no warning either. So if no
# messages arrive and nothing is logged, compare the *types*. Here, use `topic_info`; on a robot, use `ros2 topic info
# -v`. A topic should have only one type, so publish numbers on another topic, such as `/robot/beat_count`.

# %% [markdown]
# ## From a worked example to your own
#
# **Worked example.** A panel at the lab's entrance can be switched on at any time. It needs the last status right away,
# so it requests transient local, which the robot offers. Other programs may subscribe to the panel's topic even later,
# so the panel offers transient local, too.

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
# **Fill in the blanks.** The panel must also raise an alarm when no heartbeat has arrived for more than 2 s. To check
# that, a timer regularly compares the current time with the time of the last beat. Replace the `...`, and add the
# missing subscription. Until you do, the cell prints a reminder.

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


seen = ...
if LIMIT_S is not ...:
    alarm_panel = fresh(AlarmPanel)
    await run(alarm_panel, seconds=9)
    alarms = alarm_panel.alarms
    print("alarm:", alarms.count(True), "times; no alarm:", alarms.count(False))
    seen = LIMIT_S, "beats" if alarm_panel.beats else "no beats"
yours(seen, (2.0, "beats"), "Subscribe with qos_profile_sensor_data.")
stop()

# %% [markdown]
# **Your own.** In the [exercise](../exercises/13_qos_and_discovery.ipynb), you build a dashboard that starts late. It
# shows the last status right away. When the robot's heartbeat stops, the dashboard raises an alarm within three
# seconds.

# %% [markdown]
# ## Check yourself
#
# **1. A camera offers best effort. Your node subscribes with `10` and receives nothing. What do you change?**
#
# <details><summary>a) The reliability of your subscription, to best effort</summary>
#
# ✓ `10` requests reliable delivery, which is more than the camera offers. `qos_profile_sensor_data` is made for this
# case.
#
# </details>
# <details><summary>b) The depth, because 10 is too small for images</summary>
#
# ✗ The depth is the length of your own queue, so it doesn't affect the match.
#
# </details>
# <details><summary>c) The durability of your subscription, to transient local</summary>
#
# ✗ Then your subscription would request two things that the camera doesn't offer.
#
# </details>
#
# **2. A publisher is reliable and transient local. A subscription is best effort and volatile. What arrives?**
#
# <details><summary>a) Nothing, because the profiles differ</summary>
#
# ✗ Profiles may differ. Each offered policy only has to be at least as good as the requested one, and here, both are
# better.
#
# </details>
# <details><summary>b) Every message after the match</summary>
#
# ✓ The two match, but the subscription didn't request earlier messages.
#
# </details>
# <details><summary>c) Every message after the match, and the last one before it</summary>
#
# ✗ The publisher sends earlier messages only to subscriptions that request transient local.
#
# </details>
#
# **3. A volatile publisher sends the map once. Your node starts later and requests transient local. What does it get?**
#
# <details><summary>a) The map, because your subscription requests it</summary>
#
# ✗ The publisher would have to keep the map for you, but a volatile publisher keeps nothing for late subscriptions.
#
# </details>
# <details><summary>b) Not this map, but the next one</summary>
#
# ✗ Your node won't get the next one either. The publisher offers less than your node requests, so the two don't match.
#
# </details>
# <details><summary>c) Neither this map nor a later one</summary>
#
# ✓ The two don't match. A warning names the policy, `DURABILITY`.
#
# </details>
#
# **4. You request a deadline of 2 s, and the robot is still switched off. When is `on_missed` called for the first time?**
#
# <details><summary>a) After the first message, once 2 s pass without another one</summary>
#
# ✓ There's no event before the first message. To display `unknown` until then, use a timer.
#
# </details>
# <details><summary>b) 2 s after the subscription was created</summary>
#
# ✗ DDS measures the time from a message, and none has arrived yet.
#
# </details>
# <details><summary>c) As soon as the robot is switched on</summary>
#
# ✗ At that point, messages begin to arrive, so no deadline is missed.
#
# </details>
#
# **5. `topic_info` lists a publisher and a subscription. No messages arrive, and the log is empty. What do you check first?**
#
# <details><summary>a) The domain</summary>
#
# ✗ If the domains differed, the list wouldn't contain both.
#
# </details>
# <details><summary>b) The types</summary>
#
# ✓ A QoS mismatch is logged, but with Fast DDS, a type mismatch between two processes isn't. If the types are the same,
# check that your code spins the node.
#
# </details>
# <details><summary>c) The network cable</summary>
#
# ✗ Without a network connection, the two programs couldn't discover each other, so the list would contain only one of
# them.
#
# </details>

# %% [markdown]
# ## Talk it through
#
# Write down your own answer first. Then copy the prompt into an AI assistant, or discuss it with a colleague.
#
# ```text
# I'm programming a robot with ROS 2 Jazzy in Python (rclpy). It publishes a laser scan at
# 20 Hz, a map that changes every few minutes, and an emergency stop. A tablet connects
# and disconnects over an unreliable wireless network. Which reliability, durability,
# deadline, and depth would you choose for each topic, on both sides? And how does the
# tablet notice that it has lost the robot? Make sure that every rclpy function you use
# exists in Jazzy.
# ```
#
# <details><summary>What a good answer covers</summary>
#
# **The scan:** best effort, volatile, and a small depth. By the time a resent scan arrives, it's out of date, and
# resending takes up bandwidth.
#
# **The map:** reliable and transient local, with depth 1 on the publisher. The tablet has to request transient local,
# too.
#
# **The emergency stop:** reliable delivery isn't enough, because a stop message that doesn't arrive stops nothing.
# Reverse the logic: the tablet sends "keep going" as a heartbeat, and the robot stops when the heartbeat does.
#
# **The lost connection:** a deadline on the scan, offered by the robot, or a timer that checks the age of the last
# message. The tablet should display the age of its data.
#
# Good answers add that a deadline takes effect only after the first message. They also recommend testing all of this by
# pulling the plug.
#
# </details>
#
# <details><summary>What to check in the reply</summary>
#
# Watch for these two mistakes. We checked both with this course's rclpy.
#
# - **`QoSProfile(depth=10, deadline=0.1)`:** The profile doesn't accept a plain number of seconds. Use
#   `Duration(seconds=0.1)`.
# - **A best-effort subscription doesn't match a reliable publisher:** It does, because it requests less than the
#   publisher offers. The reverse combination, a reliable subscription and a best-effort publisher, doesn't match.
#
# </details>

# %% [markdown]
# ## Take away
#
# - A publisher offers a QoS profile, and a subscription requests one. They match if every offered policy is at least as
#   good as the requested one.
# - If the profiles don't match, each side logs one line, and no messages arrive. `qos_check_compatible` and
#   `topic_info` give the reason.
# - With transient local on both sides, a late subscription gets the publisher's last `depth` messages right away. Use
#   it for states.
# - To notice silence, request a deadline, but only if the publisher offers one. A timer that checks the age of the last
#   message works with any publisher.
# - If both sides are listed, but nothing arrives and nothing is logged, compare the types.
#
# **Before:** [12 · Services](12_services.ipynb)
#
# **Deeper:** [13 · Deeper: discovery and the first messages](13_qos_and_discovery_deeper.ipynb)
#
# **Next:** [14 · Arrays and filters](14_arrays_and_filters.ipynb)
#
# **More:** [About quality of service
# settings](https://docs.ros.org/en/jazzy/Concepts/Intermediate/About-Quality-of-Service-Settings.html), with all
# policies, and [About discovery](https://docs.ros.org/en/jazzy/Concepts/Basic/About-Discovery.html).
