# %% [markdown]
# # 09 · The joint positions
#
# A planner, a safety monitor, and a drawing on your screen all need the joint angles. How often should a robot publish
# them?
#
# - **Minutes:** 50
# - **You need:** lessons [05](05_timers.ipynb) and [08](08_humanoid_status_publisher.ipynb)
# - **You will be able to:**
#   - publish an array of joint angles
#   - choose and justify a rate for it
#   - use the angles in a subscriber
#   - measure how much CPU time it takes to publish at a given rate
# - **Not covered:** joint names inside the message (`sensor_msgs/JointState`), the connections between links (URDF),
#   motor control

# %% [markdown]
# The next cell starts `lesson_nodes/joint_position_publisher.py` as a separate program. It publishes twelve angles to
# `/robot/joint_positions`, twenty times a second. The notebook only subscribes to that topic.

# %%
from lesson_nodes import joint_position_publisher
from workbook.lesson import start, stop, watch_robot

print("started", start(joint_position_publisher, period_s=0.05))
await watch_robot(seconds=6, ease=0.1)

# %% [markdown]
# Every pose that you saw was sent over DDS from one process to another as twelve numbers:
#
# | index | joint | index | joint | index | joint |
# |---|---|---|---|---|---|
# | 0 | neck | 4 | right shoulder | 8 | left ankle |
# | 1 | waist | 5 | right elbow | 9 | right hip |
# | 2 | left shoulder | 6 | left hip | 10 | right knee |
# | 3 | left elbow | 7 | left knee | 11 | right ankle |
#
# The angles are in radians, so π is half a turn. The robot faces you, so its left arm is on your right.
#
# [the same without helpers: start, record, init, fresh, run]

# %%
from workbook.ros.tools import topic_info

topic_info("/robot/joint_positions")

# %%
stop()

# %% [markdown]
# How far apart can the messages be before the wave stops looking like a wave? Move the slider while the cell runs.

# %%
from workbook.lesson import knob

await knob(joint_position_publisher, "period_s", 0.5, between=(0.05, 1.0), seconds=8)

# %% [markdown] prediction="the-slow-drawing"
# ## Predict
#
# In lesson 08, the node published the battery level at 0.5 Hz, one message every 2 s. Suppose we publish the *waving*
# robot's joint angles just as slowly. A program draws the robot using the last message that arrived.
#
# How far off is the elbow in that drawing at worst? The elbow swings back and forth through about 1 rad (57°).
#
# - **a** Hardly at all: the last message is nearly right.
#   when `share_of_the_swing < 0.05`
#   ✗ The last message was right when it was sent. Up to two seconds later, the elbow is somewhere else.
# - **b** By about a tenth of the swing.
#   when `0.05 <= share_of_the_swing < 0.5`
#   ✗ In two seconds, the elbow has time for more than a whole swing, so the error can be much larger than that.
# - **c** Not at all: DDS fills in the values between two messages.
#   ✗ DDS only delivers messages. It doesn't interpret the numbers, and it never makes up new ones.
# - **d** By nearly the whole swing.
#   when `share_of_the_swing >= 0.5`
#   ✓ Between two messages, the elbow has time to move from one end of its swing to the other.

# %%
from workbook.lesson import predict, reveal

predict("the-slow-drawing")

# %% [markdown]
# ## Run it
#
# We record the same publisher with a period of 2 s. `record` controls the robot's clock, so 14 s of simulated time
# (*robot time*) takes about one second of real time.

# %%
from workbook.lesson import arrivals, record, values

TOPIC = "/robot/joint_positions"
slow = record(joint_position_publisher, {TOPIC: 2.0}, seconds=14, period_s=2.0)

print("arrived at", arrivals(slow, TOPIC), "s")
print("values per message:", {len(angles) for angles in values(slow, TOPIC)})

# %% [markdown]
# We know how the robot really moves, because the publisher computes every pose with `waving(t)`. So we can compare the
# real elbow angle with the one in the last message.

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
# Here's the real elbow angle, along with the angle in the newest message at each moment:

# %%
from workbook.pictures.figures import figure, show
from workbook.pictures.palette import AMBER, BLUE

fig, axes = figure(7.2, 2.8)
axes.plot(moments, truth, color=BLUE)
axes.step(moments, last_known(slow), where="post", color=AMBER)
axes.set(xlabel="robot time (s)", ylabel="left elbow (rad)", xlim=(2, 14))
right = axes.get_yaxis_transform()  # x in widths of the axes, y in rad
axes.text(1.01, 0.85, "the real elbow", color=BLUE, weight="bold", transform=right)
axes.text(1.01, 0.13, "the last message", color=AMBER, weight="bold", transform=right)
axes.set_title(f"At 0.5 Hz, the last message is wrong by up to {worst:.1f} rad")
show(
    fig,
    "the elbow swings back and forth in 1.25 s; the angle in the last message stays "
    "the same for two seconds and is often at the other end of the swing",
)

# %% [markdown]
# Between two messages, a subscriber gets no new values, because DDS delivers messages but doesn't interpolate between
# them. The elbow swings back and forth 0.8 times per second, which is more than once every 2 s. The battery, in
# contrast, drains by at most 0.5% in 2 s, so the last battery message is never off by more than that.
#
# **Publish often enough that a subscriber gets every change that matters to it.**
#
# The message type is `Float32MultiArray`: a list of 32-bit floats with an optional `layout` that describes rows and
# columns. It has no joint names, so publisher and subscriber must agree on an order, such as the one in the table
# above.

# %%
from std_msgs.msg import Float32MultiArray

message = Float32MultiArray(data=waving(0.25))
kind = type(message.data).__name__
code = repr(message.data.typecode)
print(len(message.data), "values, stored as", kind, "of type", code)
print("left elbow sent:", waving(0.25)[ELBOW])
print("left elbow kept:", message.data[ELBOW])

# %% [markdown]
# The two numbers differ in the eighth digit, because a Python `float` has 64 bits, but each value in the field has only
# 32. For an angle, that difference doesn't matter. But never compare such values with `==`.
#
# **Your turn.** An index such as 4 doesn't say which joint it stands for. Use the joint's name to look up the right
# shoulder's angle in `message`.

# %% id="your-joint"
from workbook.lesson import yours

right_shoulder = ...  # TODO: a value of message.data; JOINTS.index(...) gives its index

yours(right_shoulder, waving(0.25)[4], 'message.data[JOINTS.index("right_shoulder")]')

# %% [markdown] prediction="ten-hertz"
# ## Change it
#
# ### Experiment 1: 10 Hz instead of 0.5 Hz
#
# Now the joint publisher sends at 10 Hz. Compared with 0.5 Hz, how large is the largest error in the last known elbow
# angle?
#
# - **a** less than a third as large
#   when `share_of_the_error < 1 / 3`
#   ✓ The last message is at most 0.1 s old, instead of 2 s. In that time, the elbow moves only a little.
# - **b** about half as large
#   when `1 / 3 <= share_of_the_error <= 0.8`
#   ✗ There are twenty times as many messages, so the error shrinks by much more than half.
# - **c** just as large, because the motion is the same
#   when `share_of_the_error > 0.8`
#   ✗ The motion is the same, but the error grows with the time since the last message, which is shorter now.

# %%
predict("ten-hertz")

# %%
fast = record(joint_position_publisher, {TOPIC: 0.1}, seconds=14, period_s=0.1)
worst_of_fast = np.abs(last_known(fast) - truth).max()
reveal("ten-hertz", share_of_the_error=float(worst_of_fast / worst))

# %% [markdown]
# A joint can turn a few radians per second, while the battery loses only a fraction of a percent. So the joint angles
# must be published more often. Typically, a battery level is published every few seconds, but joint angles for a
# planner are published at 10 to 100 Hz. Motor control inside a joint runs at 1000 Hz or more, but not in Python and not
# over a topic. The exercise asks for only 0.5 Hz, because its angles are simulated and no program uses them to control
# anything.
#
# **Your turn.** A knee turns at up to 3 rad/s. A safety monitor uses the angle in the last message, which may be off by
# at most 0.05 rad. What's the lowest rate that's high enough?

# %% id="your-rate"
lowest_hz = ...  # TODO: messages per second, from 3 rad/s and 0.05 rad

yours(lowest_hz, 60.0, "In one period, the knee may turn by at most 0.05 rad.")

# %% [markdown] prediction="the-hand-tracker"
# ### Experiment 2: a subscriber that uses the angles
#
# A node called the *hand tracker* subscribes to the angles. It computes the left hand's height above the shoulder and
# publishes the result. The tracker has only one callback. It belongs to the subscription and runs once per message
# (lesson 04).
#
# The robot's hand rises and falls by 13 cm, 0.8 times a second. Each second, 20 messages arrive. What's the largest
# step from one height to the next?
#
# - **a** about 0.65 cm: 13 cm in 20 messages
#   when `largest_step_cm < 0.8`
#   ✗ In a second, the hand moves farther than 13 cm: it goes up and down 0.8 times.
# - **b** about 2 cm: in half a wave (12.5 messages), the hand rises 13 cm, but not at a constant speed
#   when `largest_step_cm >= 1.5`
#   ✓ The hand rises for 0.625 s, or 12.5 messages, so it averages 1 cm per message. At its fastest, it moves about
#   twice that far.
# - **c** about 1 cm: in half a wave (12.5 messages), the hand rises 13 cm
#   when `0.8 <= largest_step_cm < 1.5`
#   ✗ That's the average step. The hand slows down where it reverses direction, so it's faster in between.
# - **d** That depends on when the tracker's callback runs.
#   ✗ The height depends only on the message, not on the time at which the callback runs.

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
# So between two messages, the height changes by at most 2 cm. Here's the tracker. It spins in this notebook, while the
# waving robot runs in a separate process.

# %%
from rclpy.node import Node
from std_msgs.msg import Float32

from workbook.lesson import about, fresh, init, run

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

live_cm = [100 * height for height in tracker.heights]
print(len(live_cm), "heights published")
print("lowest: ", about(min(live_cm), "cm", between=(32.5, 33.5)))
print("highest:", about(max(live_cm), "cm", between=(45, 46)))

# %%
fig, axes = figure(7.2, 2.4)
axes.plot(range(1, len(live_cm) + 1), live_cm, ".-", color=BLUE)
axes.set(xlabel="number of the message", ylabel="hand above shoulder (cm)")
axes.set_title("Each message becomes one height: 25 of them per wave")
show(fig, "a hundred dots, one for each message: the waving hand goes up and down")

# %% [markdown]
# The node publishes one height per message. Many nodes on a robot work like this: they subscribe to one topic, compute
# something more useful, and publish the result.

# %% [markdown] prediction="a-hundred-hertz"
# ### Experiment 3: the cost of 100 Hz
#
# What does a higher rate cost? We run the publisher at three rates, each time in a separate process. Each time, the
# operating system reports how much CPU time the process used, not counting its startup.
#
# At 100 Hz, there are 200 times as many messages as at 0.5 Hz. How much CPU time does the program use, compared with
# 0.5 Hz?
#
# - **a** about 200 times as much
#   when `times_as_much >= 200`
#   ✗ At 0.5 Hz, much of the CPU time doesn't go to messages, because DDS works in the background at any rate.
# - **b** the same amount
#   when `times_as_much <= 1`
#   ✗ Filling, serializing, and sending a message takes CPU time. At 100 Hz, that happens 200 times as often.
# - **c** more, but less than 200 times as much
#   when `1 < times_as_much < 200`
#   ✓ Each message costs a little CPU time. But DDS's background work costs the same at any rate, and at 0.5 Hz, it's a
#   large part of the total.

# %%
predict("a-hundred-hertz")

# %%
from rclpy.serialization import serialize_message

size = len(serialize_message(message))
print("one message is", size, "bytes on the wire, headers of DDS not counted")
for hz in (0.5, 10, 100):
    print(f"{hz:>5} Hz: {hz * size:>6.0f} bytes per second")

# %%
from workbook.lesson import processor_seconds

SECONDS = {0.5: 10.0, 10.0: 4.0, 100.0: 4.0}  # how long we measure at each rate
USUAL = {0.5: (0.05, 20), 10.0: (0.2, 40), 100.0: (1, 100)}
used = {}
for hz, seconds in SECONDS.items():
    busy = processor_seconds(
        joint_position_publisher, seconds=seconds, with_start=False, period_s=1 / hz
    )
    used[hz] = busy / seconds  # share of one core
    print(f"{hz:>5} Hz:", about(100 * used[hz], "%", between=USUAL[hz]), "of one core")
times = used[100.0] / used[0.5]
print("200 times the messages:", about(times, "times the CPU time", between=(0.3, 200)))

# %%
reveal("a-hundred-hertz", times_as_much=times)

# %%
fig, axes = figure(5.2, 2.4)
percent = {f"{hz:g} Hz": 100 * busy for hz, busy in used.items()}
bars = axes.bar(list(percent), list(percent.values()), color=BLUE)
axes.bar_label(bars, fmt="%.1f%%")
axes.set_title(f"200× the messages, {times:.0f}× the CPU time")
axes.set(ylabel="CPU time (% of one core)")
axes.margins(y=0.2)
axes.grid(False)
show(
    fig,
    "processor time of the publisher at 0.5, 10 and 100 Hz: "
    "it grows, but less than the number of messages",
)

# %% [markdown]
# These numbers exclude the program's startup. At 0.5 Hz, much of the CPU time goes to background work: DDS exchanges
# its own messages with other programs. The remaining CPU time grows with the rate, but less than proportionally. On our
# otherwise idle machine, each message cost far less CPU time at 100 Hz than at 10 Hz; we haven't investigated why.
#
# So 100 Hz is affordable for *one* publisher. But every message costs CPU time in each subscriber, too, and a robot has
# many topics. Also, while a Python node is busy with one topic, messages on its other topics have to wait (lesson 10).

# %% [markdown]
# ## When it goes wrong
#
# **A list instead of a message.** The most common mistake with arrays is to publish the list itself.

# %% tags=["raises-exception"]
import rclpy

node = fresh(lambda: rclpy.create_node("mistakes"))
joint_pub = node.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)
joint_pub.publish(waving(0.0))

# %% [markdown]
# `publish` needs a message, so put the list into a message's `data` field: `Float32MultiArray(data=angles)`.
#
# **One number instead of a list.** The field is always an array, even for a single value.

# %% tags=["raises-exception"]
Float32MultiArray(data=1.57)

# %% [markdown]
# The field needs a sequence, so write a list with one element: `[1.57]`.
#
# **Eleven values, degrees, or NaN.** None of these raises an exception, because ROS accepts any array of floats. Only a
# program that *uses* the angles can detect the mistake. The next two figures should both show the left arm stretched
# out to the side. In the first, the shoulder angle is in radians. In the second, it's in degrees by mistake.

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
# So check the angles where you compute them: there must be twelve, and each must be finite (`math.isfinite`) and within
# ±π. Where mistakes are dangerous, check received angles, too, because a motor that receives NaN may do anything.
#
# **Your turn.** Write that check.

# %% id="your-check"
def is_pose(angles) -> bool:
    """Return whether these are twelve finite angles within ±π."""
    return ...  # TODO: a condition on the length, and one on all angles


tries = (waving(0.0), [0.0] * 11, [math.nan] * 12, [90.0] * 12)
yours(
    [is_pose(angles) for angles in tries],
    [True, False, False, False],
    "len(angles) == 12 and all(math.isfinite(a) and abs(a) <= math.pi for a in angles)",
)

# %% [markdown]
# ## From a worked example to your own
#
# **Worked example.** We add one more topic to lesson 08's status publisher: the head's angle, published once a second.
# This requires three additions: a publisher, a timer, and a callback. The two existing topics stay as they are, because
# `super().__init__()` still creates their publishers and timers.

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
# **Fill in the blanks.** Now publish the angles of the left hand's five fingers to `/robot/finger_positions`, twice a
# second. Replace each `...` with your code. Until you do, the cell prints a reminder.

# %%
FINGER_PERIOD_S = ...  # TODO: seconds between two messages at 2 Hz


class WithFingers(WithHeadAngle):
    """Adds the angles of five fingers (rad, 2 Hz) on /robot/finger_positions."""

    def __init__(self) -> None:
        super().__init__()
        # TODO: a publisher of Float32MultiArray on /robot/finger_positions
        self.finger_pub = ...
        if FINGER_PERIOD_S is not ...:
            self.finger_timer = self.create_timer(FINGER_PERIOD_S, self.publish_fingers)

    def publish_fingers(self) -> None:
        angles = ...  # TODO: a list of five angles (rad)
        self.finger_pub.publish(Float32MultiArray(data=angles))


gripping = fresh(WithFingers)
sizes = []
gripping.create_subscription(
    Float32MultiArray,
    "/robot/finger_positions",
    lambda message: sizes.append(len(message.data)),
    10,
)
await run(gripping, seconds=2.5)
yours((FINGER_PERIOD_S, sizes[:3]), (0.5, [5, 5, 5]), "At 2 Hz, the period is 0.5 s.")

# %% [markdown]
# **Your own.** In the [exercise](../exercises/09_joint_positions.ipynb), you write the complete node. It publishes the
# twelve joint angles to `/robot/joint_positions` every 2 s, along with the status and the battery level. The judge
# checks only your node's topics and messages.

# %% [markdown]
# ## Check yourself
#
# **1. A joint can move through its whole range in 0.5 s, and a safety monitor must detect such a movement. Which rate is suitable?**
#
# <details><summary>a) 0.5 Hz, as in the exercise</summary>
#
# ✗ There are two seconds between messages. In that time, the joint can move through its whole range and back, twice,
# without being detected.
#
# </details>
# <details><summary>b) 20 to 100 Hz</summary>
#
# ✓ Each movement is covered by ten or more messages, and a single Python node can handle that rate.
#
# </details>
# <details><summary>c) As fast as the loop can run</summary>
#
# ✗ Every message costs CPU time in every subscriber. A rate that's higher than necessary takes that time away from
# other topics.
#
# </details>
#
# **2. Your message contains eleven values. What detects the mistake?**
#
# <details><summary>a) rclpy, when you call publish()</summary>
#
# ✗ A Float32MultiArray can have any length. rclpy may check the values' types, but it doesn't count the values.
#
# </details>
# <details><summary>b) DDS, because the publisher announced twelve</summary>
#
# ✗ A publisher doesn't announce a length. The type just says "a sequence of floats".
#
# </details>
# <details><summary>c) Only a subscriber that counts them</summary>
#
# ✓ Nothing else checks the length, so both sides must make sure that there are twelve values in the agreed order.
#
# </details>
#
# **3. By mistake, a program publishes a quarter turn in degrees: 90.0. What do subscribers get?**
#
# <details><summary>a) 90.0, which they interpret as radians</summary>
#
# ✓ The message contains a number without a unit. 90 rad is a bit more than 14 turns.
#
# </details>
# <details><summary>b) Nothing: rclpy rejects angles above π</summary>
#
# ✗ rclpy accepts any float. Only a program that uses the angle can detect the mistake.
#
# </details>
# <details><summary>c) 1.57: the message type specifies the unit</summary>
#
# ✗ A Float32MultiArray has no unit, so nothing gets converted. Publisher and subscriber have to agree on radians.
#
# </details>
#
# **4. The angles used to arrive at 20 Hz, but now they arrive at only 5 Hz. How many heights does the hand tracker publish?**
#
# <details><summary>a) 20 a second, most of them repeated</summary>
#
# ✗ That would take a timer. The tracker doesn't have one, so it never repeats a value.
#
# </details>
# <details><summary>b) 5 a second</summary>
#
# ✓ Each message triggers the callback once, and each call publishes one height.
#
# </details>
# <details><summary>c) 20 a second, with values interpolated between the last two messages</summary>
#
# ✗ Neither DDS nor the tracker makes up values. Between two messages, a subscriber gets no new data.
#
# </details>

# %% [markdown]
# ## Talk it through
#
# Read this prompt and write down your own answer. Then copy the prompt into an AI assistant, or discuss it with a
# colleague.
#
# ```text
# I'm programming a robot with ROS 2 Jazzy in Python (rclpy). My humanoid publishes twelve
# joint angles. A colleague wants them at 100 Hz for logging, the dashboard needs them at
# 2 Hz, and the arm planner needs them at 50 Hz. Should I create three topics, one fast
# topic, or something else? What are the arguments for each? Make sure that every rclpy
# function you use exists in Jazzy.
# ```
#
# <details><summary>What a good answer covers</summary>
#
# A good answer suggests one topic at the fastest rate that's really needed. Slower subscribers sample it, with a queue
# depth of 1 or with a timer callback that uses the last message. Three topics with the same angles can contradict each
# other. But every message costs each subscriber CPU time, so for a slow Python subscriber, a second topic with fewer
# messages can make sense. A real robot would use `sensor_msgs/JointState`, which contains names, positions, velocities,
# and a time stamp.
#
# </details>
#
# <details><summary>What to check in the reply</summary>
#
# Watch for these two pieces of advice. We tested both with the rclpy version that this course uses, and both are wrong.
#
# - **Fill in `layout.dim`, or no subscriber can read `data`:** The twelve numbers in `data` arrive even without a
#   layout, because a layout only describes them.
# - **Assign a 4 × 3 NumPy array of the angles to `data`:** The field is one-dimensional, so this raises an error.
#   Flatten the array, and pass it to the constructor instead: `Float32MultiArray(data=angles.ravel())`. Assigning it
#   with `message.data = angles.ravel()` raises an error here, too, because field checks (lesson 03) are on.
#
# </details>

# %% [markdown]
# ## Take away
#
# - A `Float32MultiArray` can contain any number of floats, so publisher and subscriber must agree on their order and
#   number.
# - A node that publishes one result per message needs no timer, because each message triggers its callback.
# - Check the angles where you compute them: there must be the right number of them, and each must be finite and in
#   range.
# - A message is a snapshot, and a subscriber gets nothing new until the next one arrives.
# - The right rate depends on how fast the value changes and how much detail the subscribers need.
#
# **Before:** [08 · The humanoid status publisher](08_humanoid_status_publisher.ipynb)
#
# **Next:** the exercise, and then [10 · Slow callbacks](10_slow_callbacks.ipynb): what happens if the work takes longer
# than the period?
#
# **More:** [Publishing and subscribing in Python](https://docs.ros.org/en/jazzy/Tutorials/Beginner-Client-Libraries/Writing-A-Simple-Py-Publisher-And-Subscriber.html)
# and [about interfaces](https://docs.ros.org/en/jazzy/Concepts/Basic/About-Interfaces.html).
