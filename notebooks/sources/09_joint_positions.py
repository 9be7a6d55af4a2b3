# %% [markdown]
# # 09 · The joint positions
#
# A planner, a safety monitor and a picture on your screen all need the joint angles. How often should a robot publish them?
#
# - **Minutes:** 45
# - **You need:** lessons [05](05_timers.ipynb) and [08](08_humanoid_status_publisher.ipynb)
# - **You will be able to:**
#   - publish an array of joint angles
#   - choose its rate with a reason
#   - use it in a subscriber
#   - measure what a rate costs
# - **Left out:** names inside the message (`sensor_msgs/JointState`), how links are connected (URDF), motor control

# %% [markdown]
# The next cell starts a program of its own, `lesson_nodes/joint_position_publisher.py`. It publishes twelve angles
# on `/robot/joint_positions`, twenty times a second. The notebook only listens.

# %%
from lesson_nodes import joint_position_publisher
from workbook.lesson import start, stop, watch_robot

print("started", start(joint_position_publisher, period_s=0.05))
await watch_robot(seconds=6, ease=0.1)

# %% [markdown]
# Every pose that you saw went through DDS, from one process to another, as twelve numbers:
#
# | index | joint | index | joint | index | joint |
# |---|---|---|---|---|---|
# | 0 | neck | 4 | right shoulder | 8 | left ankle |
# | 1 | waist | 5 | right elbow | 9 | right hip |
# | 2 | left shoulder | 6 | left hip | 10 | right knee |
# | 3 | left elbow | 7 | left knee | 11 | right ankle |
#
# The angles are radians: π is half a turn. The robot faces you, so its left arm is on your right.

# %%
from workbook.ros.tools import topic_info

topic_info("/robot/joint_positions")

# %%
stop()

# %% [markdown]
# How rarely may the program publish before the wave no longer looks like a wave? Move the slider while the cell runs.

# %%
from workbook.lesson import knob

await knob(joint_position_publisher, "period_s", 0.5, between=(0.05, 1.0), seconds=8)

# %% [markdown] prediction="the-slow-drawing"
# ## Predict
#
# The battery of lesson 08 is published at 0.5 Hz, one message every 2 s. Suppose we publish the joint angles of the
# *waving* robot just as slowly, and a program draws the robot from the last message that arrived.
#
# How wrong is that drawing at worst? The elbow swings by about 1 rad (57°) from one end to the other.
#
# - **a** Hardly at all: the last message is nearly true.
#   when `share_of_the_swing < 0.05`
#   ✗ The last message was true when it was sent. Up to two seconds later the elbow is somewhere else.
# - **b** By about a tenth of the swing.
#   when `0.05 <= share_of_the_swing < 0.5`
#   ✗ In two seconds the elbow has time for a whole swing and more, so the error can be much larger than that.
# - **c** It is not wrong: DDS fills in the values between two messages.
#   ✗ DDS carries messages. It does not know what the numbers mean, and it never makes up new ones.
# - **d** By nearly the whole swing.
#   when `share_of_the_swing >= 0.5`
#   ✓ The elbow goes from one end to the other in less time than passes between two messages.

# %%
from workbook.lesson import predict, reveal

predict("the-slow-drawing")

# %% [markdown]
# ## Run it
#
# We record the same publisher with a period of 2 s. The recorder drives the robot's clock, so 14 s of robot time take
# about a second.

# %%
from workbook.lesson import arrivals, record, values

TOPIC = "/robot/joint_positions"
slow = record(joint_position_publisher, {TOPIC: 2.0}, seconds=14, period_s=2.0)

print("arrived at", arrivals(slow, TOPIC), "s")
print("values per message:", {len(angles) for angles in values(slow, TOPIC)})

# %% [markdown]
# We know how the robot really moves: the lesson node computes every pose with `waving(t)`. So we can compare the real elbow
# with the last message.

# %%
import numpy as np

from lesson_nodes.joint_position_publisher import JOINTS, waving

ELBOW = JOINTS.index("left_elbow")
moments = np.arange(2.0, 14.0, 0.01)
truth = np.array([waving(t)[ELBOW] for t in moments])


def last_known(recording):
    """The elbow angle (rad) of the newest message at each moment."""
    times = np.array(arrivals(recording, TOPIC))
    angles = np.array([row[ELBOW] for row in values(recording, TOPIC)])
    newest = np.searchsorted(times, moments, side="right") - 1
    return angles[newest]


swing = truth.max() - truth.min()
worst = np.abs(last_known(slow) - truth).max()
print(
    f"the elbow swings by {swing:.1f} rad; "
    f"largest difference from the last message: {worst:.1f} rad"
)
reveal("the-slow-drawing", share_of_the_swing=float(worst / swing))

# %% [markdown]
# ## Look inside
#
# Here is the real elbow, and the newest message at each moment:

# %%
from workbook.pictures.figures import figure, show
from workbook.pictures.palette import AMBER, BLUE

fig, axes = figure(7.2, 2.8)
axes.plot(moments, truth, color=BLUE)
axes.step(moments, last_known(slow), where="post", color=AMBER)
axes.set(xlabel="robot time (s)", ylabel="left elbow (rad)", xlim=(2, 18))
axes.text(14.2, 0.8, "the real elbow", color=BLUE, weight="bold")
axes.text(14.2, 0.15, "the last message", color=AMBER, weight="bold")
axes.set_title(
    "at 0.5 Hz the last message can be wrong by the whole swing", fontsize=11
)
show(
    fig,
    "the elbow swings quickly while the last known angle changes every two seconds",
)

# %% [markdown]
# Between two messages a subscriber learns nothing new: DDS delivers, it does not guess. The elbow swings 0.8 times a
# second. In 2 s it can go to the other end and back. The battery is different: it drains by at most 0.5 % in 2 s, so
# the last message is never wrong by more than that.
#
# **Publish often enough that a subscriber learns of every change that matters to it.**
#
# The message type is `Float32MultiArray`: a list of 32-bit floats with an optional `layout` that describes rows and
# columns. It has no joint names. Sender and receiver must agree on the order, as we did in the table above.

# %%
from std_msgs.msg import Float32MultiArray

message = Float32MultiArray(data=waving(0.25))
kind = type(message.data).__name__
code = repr(message.data.typecode)
print(len(message.data), "values, stored as", kind, "of type", code)
print("left elbow sent:", waving(0.25)[ELBOW])
print("left elbow kept:", message.data[ELBOW])

# %% [markdown]
# The two numbers differ in the eighth digit: a Python `float` has 64 bits and the field has 32. For an angle that does not
# matter. But never compare such values with `==`.

# %% [markdown] prediction="ten-hertz"
# ## Change it
#
# ### Experiment 1: joints faster than the battery?
#
# Now the joint publisher sends at 10 Hz. The worst error of the last known elbow angle will be:
#
# - **a** less than a third
#   when `share_of_the_error < 1 / 3`
#   ✓ The last message is at most 0.1 s old, instead of 2 s. In that time the elbow moves only a little.
# - **b** about half
#   when `1 / 3 <= share_of_the_error <= 0.8`
#   ✗ Twenty times as many messages come as before. The error shrinks by much more than half.
# - **c** the same, because the motion is the same
#   when `share_of_the_error > 0.8`
#   ✗ The motion is the same, but the error grows with the time since the last message, and that is shorter now.

# %%
predict("ten-hertz")

# %%
fast = record(joint_position_publisher, {TOPIC: 0.1}, seconds=14, period_s=0.1)
worst_of_fast = np.abs(last_known(fast) - truth).max()
reveal("ten-hertz", share_of_the_error=float(worst_of_fast / worst))

# %% [markdown]
# Joints change by radians in a second, the battery by a fraction of a percent. So the joints need the faster topic.
# Batteries: once every few seconds. Joints that a planner uses: 10 to 100 Hz. Motor control inside the joint: 1000 Hz and
# more, and not over a Python topic. The exercise asks for 0.5 Hz all the same: there the angles are simulated, and no
# program steers by them.

# %% [markdown] prediction="the-hand-tracker"
# ### Experiment 2: a subscriber that uses the angles
#
# A node subscribes to the angles. It computes how high the left hand is above the shoulder, and publishes that. It has no
# timer: its callback runs once for each message (lesson 04).
#
# The hand of the waving robot goes up and down by 13 cm, 0.8 times a second. 20 messages come in a second. How large is
# the largest step from one height to the next?
#
# - **a** about 0.65 cm: 13 cm in 20 messages
#   when `largest_step_cm < 0.8`
#   ✗ In a second the hand does more than one way of 13 cm: it goes up and down, 0.8 times.
# - **b** about 2 cm: more than 13 cm in 12.5 messages
#   when `largest_step_cm >= 1.5`
#   ✓ One way takes 0.625 s, or 12.5 messages, so 1 cm on average. Where the hand is fastest, it is about twice that.
# - **c** about 1 cm: 13 cm in 12.5 messages
#   when `0.8 <= largest_step_cm < 1.5`
#   ✗ That is the average step. The hand slows down where it turns, so it is faster in between.
# - **d** That depends on when the callback of the tracker runs.
#   ✗ The height is computed from the message, not from the time at which it is handled.

# %%
predict("the-hand-tracker")

# %%
import math
from itertools import pairwise
from statistics import mean

UPPER_ARM, FOREARM = 0.30, 0.28  # m


def hand_height(angles) -> float:
    """How high the left hand is above the shoulder (m)."""
    shoulder = angles[JOINTS.index("left_shoulder")]
    elbow = angles[JOINTS.index("left_elbow")]
    return -UPPER_ARM * math.cos(shoulder) - FOREARM * math.cos(shoulder + elbow)


wave = record(joint_position_publisher, {TOPIC: 0.05}, seconds=14, period_s=0.05)
heights_cm = [100 * hand_height(angles) for angles in values(wave, TOPIC)]
steps_cm = [abs(later - earlier) for earlier, later in pairwise(heights_cm)]

print(f"from {min(heights_cm):.0f} to {max(heights_cm):.0f} cm above the shoulder")
print(f"steps: {mean(steps_cm):.0f} cm on average, {max(steps_cm):.0f} cm at most")
reveal("the-hand-tracker", largest_step_cm=max(steps_cm))

# %% [markdown]
# So a tracker can say where the hand is to within 2 cm. Here is the node. It spins in this notebook, and the waving robot
# runs in its own process.

# %%
from rclpy.node import Node
from std_msgs.msg import Float32

from workbook.lesson import fresh, init, run

init()  # rclpy.init(), made so that a cell can be run again


class HandTracker(Node):
    """Publishes the left hand's height above the shoulder (m), once per message."""

    def __init__(self) -> None:
        super().__init__("hand_tracker")
        self.heights: list[float] = []
        self.height_pub = self.create_publisher(Float32, "/robot/left_hand_height", 10)
        self.create_subscription(
            Float32MultiArray, "/robot/joint_positions", self.on_joints, 10
        )

    def on_joints(self, msg: Float32MultiArray) -> None:
        height = hand_height(msg.data)
        self.heights.append(height)
        self.height_pub.publish(Float32(data=height))


start(joint_position_publisher, period_s=0.05)
tracker = fresh(HandTracker)
await run(tracker, seconds=60, until=lambda: len(tracker.heights) >= 100)
stop()

print("a hundred heights:", len(tracker.heights) >= 100)
print("always above the shoulder:", min(tracker.heights) > 0)

# %%
fig, axes = figure(7.2, 2.4)
axes.plot(range(1, len(tracker.heights) + 1), tracker.heights, ".-", color=BLUE)
axes.set(xlabel="number of the message", ylabel="hand above shoulder (m)")
axes.set_title("each message becomes one height", fontsize=11)
show(fig, "the height of the waving hand, computed from the angles, goes up and down")

# %% [markdown]
# One height for each message. Most of a robot works like this: a node subscribes to one topic, computes something more
# useful, and publishes that.

# %% [markdown] prediction="a-hundred-hertz"
# ### Experiment 3: 100 Hz instead of 0.5 Hz
#
# What does a higher rate cost? We run the publisher at three rates, each in a process of its own. The operating system says
# how much processor time it took, after it has started up.
#
# At 100 Hz there are 200 times as many messages as at 0.5 Hz. The processor time of the program will be:
#
# - **a** about 200 times as much
#   when `times_as_much >= 200`
#   ✗ At 0.5 Hz much of the processor time does not go to messages. DDS works in the background at any rate.
# - **b** the same
#   when `times_as_much <= 1`
#   ✗ Filling, serializing and sending a message is work. At 100 Hz it is done 200 times as often.
# - **c** more, but less than 200 times as much
#   when `1 < times_as_much < 200`
#   ✓ Each message costs a little. But the background work of DDS costs the same at any rate, and at 0.5 Hz it is a
#   large part.

# %%
predict("a-hundred-hertz")

# %%
from rclpy.serialization import serialize_message

size = len(serialize_message(message))
print("one message is", size, "bytes on the wire, headers of DDS not counted")
for hz in (0.5, 10, 100):
    print(f"{hz:>5} Hz: {hz * size:>6.0f} bytes per second")

# %% tags=["nbval-ignore-output"]
from workbook.lesson import processor_seconds

SECONDS = {0.5: 10.0, 10.0: 4.0, 100.0: 4.0}  # how long we measure at each rate
used = {}
for hz, seconds in SECONDS.items():
    busy = processor_seconds(
        joint_position_publisher, seconds=seconds, with_start=False, period_s=1 / hz
    )
    used[hz] = busy / seconds  # share of one core
    print(f"{hz:>5} Hz: {100 * used[hz]:5.1f} % of one core")
each_ms = 1000 * (used[100.0] - used[0.5]) / 99.5
print(f"difference between 100 Hz and 0.5 Hz, per message: {each_ms:.1f} ms")

# %%
reveal("a-hundred-hertz", times_as_much=used[100.0] / used[0.5])

# %%
print("100 Hz costs more than 0.5 Hz:", used[100.0] > used[0.5])
print("but less than 200 times as much:", used[100.0] < 200 * used[0.5])

fig, axes = figure(5.2, 2.4)
percent = {f"{hz:g} Hz": 100 * busy for hz, busy in used.items()}
bars = axes.bar(list(percent), list(percent.values()), color=BLUE)
axes.bar_label(bars, fmt="%.1f %%")
axes.set_title("200 times the messages cost less than 200 times the work", fontsize=11)
axes.set(ylabel="one core, busy (%)")
axes.margins(y=0.2)
axes.grid(False)
show(
    fig,
    "processor time of the publisher at 0.5, 10 and 100 Hz: "
    "it grows, but less than the number of messages",
)

# %% [markdown]
# The start of the program is not in these numbers. At 0.5 Hz much of it is background work: DDS keeps in touch with
# other programs. Each message adds about the same, so at high rates the cost grows with the rate.
#
# 100 Hz is affordable for *one* publisher. But every subscriber pays as well, and a robot has many topics. And a Python
# node that is busy with one topic is late for the others (lesson 10).

# %% [markdown]
# ## When it goes wrong
#
# **A plain list.** The most common slip with arrays: publishing the list instead of the message.

# %% tags=["raises-exception"]
import rclpy

node = fresh(lambda: rclpy.create_node("mistakes"))
joint_pub = node.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)
joint_pub.publish(waving(0.0))

# %% [markdown]
# `publish` needs a message. Put the list into its `data` field: `Float32MultiArray(data=angles)`.
#
# **One number instead of twelve.** The field is an array, even for a single value.

# %% tags=["raises-exception"]
Float32MultiArray(data=1.57)

# %% [markdown]
# The field needs a sequence, so write a list with one element: `[1.57]`.
#
# **Eleven values, degrees, NaN.** These raise nothing: for ROS they are an array of floats like any other. Only a program
# that *uses* the angles can notice. Here is the left arm stretched out to the side, once in radians and once with the same
# number in degrees.

# %%
from workbook.lesson import robot
from workbook.pictures.joints import pose

up = pose(left_shoulder=math.radians(90))
robot(*up, caption="left shoulder at math.radians(90)")

# %%
spun = pose(left_shoulder=90)
robot(*spun, caption="left shoulder at 90: that is 14 turns and a bit")

# %%
for bad in ([0.0] * 11, [math.nan] * 12):
    accepted = Float32MultiArray(data=bad)
    try:
        robot(*accepted.data)
    except ValueError as complaint:
        print("ROS takes it, the robot does not:", complaint)

# %% [markdown]
# So check what you send where you make it: twelve values, `math.isfinite`, within ±π. And check what you receive where
# it matters: a motor that gets NaN may do anything.

# %% [markdown]
# ## From a worked example to your own
#
# **Worked.** The status publisher of lesson 08 learns one more topic: how far the head is turned, a single angle, once a
# second. Three additions: a publisher, a timer, a callback. The two old topics stay as they were, because
# `super().__init__()` still makes them.

# %%
from rclpy.logging import LoggingSeverity, set_logger_level

from lesson_nodes.humanoid_status_publisher import HumanoidStatusPublisher

# Hides its log messages of level INFO. You saw them in lesson 08.
set_logger_level("humanoid_status_publisher", LoggingSeverity.WARN)

class WithHeadAngle(HumanoidStatusPublisher):
    """The status publisher, with the head's angle (rad, 1 Hz) on /robot/head_angle."""

    def __init__(self) -> None:
        super().__init__()
        self.head_pub = self.create_publisher(Float32, "/robot/head_angle", 10)
        self.head_timer = self.create_timer(1.0, self.publish_head)
        self.looks = 0

    def publish_head(self) -> None:
        self.looks += 1
        self.head_pub.publish(Float32(data=0.5 * math.sin(self.looks)))


looking = fresh(WithHeadAngle)
await run(looking, seconds=3.5)
print("head angles published:", looking.looks)

# %% [markdown]
# **Faded.** Now the five fingers of the left hand, on `/robot/finger_positions`, twice a second. The lines with
# `...` are yours. Until then the cell runs, and says what is missing.

# %%
FINGERS = 5
FINGER_PERIOD_S = ...  # TODO: seconds between two messages at 2 Hz


class WithFingers(WithHeadAngle):
    """Adds the angles of five fingers (rad, 2 Hz) on /robot/finger_positions."""

    def __init__(self) -> None:
        super().__init__()
        # TODO: a publisher of Float32MultiArray on /robot/finger_positions
        self.finger_pub = ...
        self.grips = 0
        if FINGER_PERIOD_S is not ...:
            self.finger_timer = self.create_timer(FINGER_PERIOD_S, self.publish_fingers)

    def publish_fingers(self) -> None:
        self.grips += 1
        angles = ...  # TODO: a list of five angles that change with self.grips
        self.finger_pub.publish(Float32MultiArray(data=angles))


if FINGER_PERIOD_S is ...:
    print("Fill in the period, the publisher and the angles, then run this cell again.")
else:
    gripping = fresh(WithFingers)
    await run(gripping, seconds=3)
    print("finger messages published:", gripping.grips)

# %% [markdown]
# **Your own.** The [exercise](../exercises/09_joint_positions.ipynb) is the whole thing: twelve joints on
# `/robot/joint_positions`, every 2 s, beside status and battery. It is judged by what your node does on the topics.

# %% [markdown]
# ## Check yourself
#
# **1. A joint moves through its whole range in half a second. A safety monitor must see it. Which rate fits?**
#
# <details><summary>a) 0.5 Hz, as in the exercise</summary>
#
# ✗ Two seconds pass between two messages. The joint can go there and back twice unseen.
#
# </details>
# <details><summary>b) 20 to 100 Hz</summary>
#
# ✓ Ten or more messages fall into each movement, and one Python node can afford it.
#
# </details>
# <details><summary>c) As fast as the loop can go</summary>
#
# ✗ Every subscriber pays for every message. A rate that is higher than needed takes time away from other topics.
#
# </details>
#
# **2. Your message holds eleven values. Who notices?**
#
# <details><summary>a) rclpy, when you call publish()</summary>
#
# ✗ A Float32MultiArray may have any length. rclpy checks types, if anything.
#
# </details>
# <details><summary>b) DDS, because the publisher announced twelve</summary>
#
# ✗ Nobody announced a length. The type says "a sequence of floats", no more.
#
# </details>
# <details><summary>c) Only a subscriber that counts</summary>
#
# ✓ So you must make sure, on both sides, that there are twelve joints in this order.
#
# </details>
#
# **3. By mistake, a program publishes a quarter turn in degrees: 90.0. What do subscribers get?**
#
# <details><summary>a) 90.0, and they take it for radians</summary>
#
# ✓ The message carries a number without a unit. 90 rad are 14 turns and a bit.
#
# </details>
# <details><summary>b) Nothing: rclpy refuses an angle above π</summary>
#
# ✗ To rclpy it is a float like any other. Only a program that uses the angle can notice.
#
# </details>
# <details><summary>c) 1.57: the message type knows its unit</summary>
#
# ✗ A Float32MultiArray has no unit, so nothing converts. Sender and receiver have to agree on radians.
#
# </details>
#
# **4. The angles came 20 times a second. Now they come 5 times. How many heights does the hand tracker publish?**
#
# <details><summary>a) 20 in a second, most of them the same as before</summary>
#
# ✗ It would need a timer for that. The tracker has none, and repeats nothing.
#
# </details>
# <details><summary>b) 5 in a second</summary>
#
# ✓ Each message that arrives calls its callback once, and each call publishes one height.
#
# </details>
# <details><summary>c) 20 in a second, with values between the last two messages</summary>
#
# ✗ Neither DDS nor the tracker makes up values. Between two messages a subscriber learns nothing new.
#
# </details>

# %% [markdown]
# ## Talk it through
#
# Copy the prompt for an AI assistant, or discuss it with a colleague. State your own view first.
#
# ```text
# I program a robot with ROS 2 Jazzy in Python (rclpy). My humanoid publishes twelve
# joint angles. A colleague wants them at 100 Hz for logging, the dashboard needs 2 Hz,
# and the arm planner 50 Hz. Should I make three topics, one fast topic, or something
# else? What speaks for each? Name only functions that exist in rclpy for Jazzy.
# ```
#
# <details><summary>What a good answer contains</summary>
#
# One topic at the fastest rate that is really needed. Slower users sample it, with queue depth 1 or a timer that reads the
# last message. Three topics of the same thing can disagree. The cost of a message is paid
# by each subscriber, so a slow one in Python may want its own, thinned topic. And a real robot would use
# `sensor_msgs/JointState`, which carries names, positions, velocities and a time stamp.
#
# </details>
#
# <details><summary>What to check in the reply</summary>
#
# Two claims you may meet. Both are wrong: each was tried with the rclpy of this course.
#
# - **Fill in `layout.dim`, or nobody can read `data`:** Twelve numbers in `data` arrive without a layout. It only
#   describes them.
# - **Assign the 4 × 3 NumPy array to `data`:** rclpy takes one row of numbers; a table raises a `TypeError`. Use
#   `angles.ravel()`.
#
# </details>

# %% [markdown]
# ## Take away
#
# - A message is a snapshot; between two of them a subscriber learns nothing new.
# - Choose a rate by how fast the value changes and who needs to know.
# - `Float32MultiArray` carries any number of floats; order and count are an agreement.
# - A subscriber that publishes needs no timer: messages drive it.
# - Check length, finiteness and range where you make the angles.
#
# **Before:** [08 · The humanoid status publisher](08_humanoid_status_publisher.ipynb)
#
# **Next:** the exercise, and then [10 · Slow callbacks](10_slow_callbacks.ipynb): what if the work takes longer than the
# period?
#
# **More:** [Publishing and subscribing in Python](https://docs.ros.org/en/jazzy/Tutorials/Beginner-Client-Libraries/Writing-A-Simple-Py-Publisher-And-Subscriber.html)
# and [about interfaces](https://docs.ros.org/en/jazzy/Concepts/Basic/About-Interfaces.html).
