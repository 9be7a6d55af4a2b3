# %% [markdown]
# # 04 · Subscriptions and callbacks
#
# How does a robot react to its own sensors? A robot that only publishes can't react at all, so it walks into walls. To
# stop in time, it needs a subscription and a callback that handles each message.
#
# - **Minutes:** 50
# - **You need:** lessons [00](00_start_here.ipynb) to 03
# - **You will be able to:**
#   - subscribe to a topic, and write the callback that handles its messages
#   - predict when the callback runs, and when it doesn't
#   - choose a subscription's queue depth
#   - measure how old a message is
# - **Not covered:** repeated work (lesson 05), the steps inside `spin` (06), long-running callbacks (10), most QoS
#   settings (13)

# %% [markdown]
# Watch the robot walk to a wall and back, again and again. One program measures the distance to the wall and publishes
# it to a topic, twenty times a second. A second program subscribes to that topic and raises the robot's arms when the
# wall is close.

# %%
from lesson_nodes import careful_robot, distance_sensor
from workbook.lesson import start, stop, watch_robot

print("started", start(distance_sensor), "and", start(careful_robot, close_m=1.2))
await watch_robot(seconds=8, ease=0.1)
stop()

# %% [markdown]
# The second program has no timer and no loop. It acts only when it receives a message:
#
# ```python
# self.create_subscription(Float32, "/robot/distance", self.on_distance, 10)
#
# def on_distance(self, message: Float32) -> None:
#     joints = posture(message.data, self.close_m)
#     self.joint_publisher.publish(Float32MultiArray(data=joints))
# ```
#
# The first line creates the **subscription**. Its arguments are the message type, the topic, the method to call, and a
# *depth*, which Experiment 1 explains. The method is the **callback**: you write it, and rclpy calls it once for each
# message.
#
# Now set `close_m` to `2.5` in the first code cell, and rerun that cell.

# %% [markdown] prediction="five-distances"
# ## Predict
#
# Now you play the sensor. This notebook contains two nodes: `sensor` has a publisher, and `guard` has a subscription. A
# third node, which we call the *black box*, runs in a separate program. It subscribes to the same topic and counts the
# messages.
#
# ```python
# for distance in (2.0, 1.6, 1.2, 0.8, 0.4):
#     sensor.publisher.publish(Float32(data=distance))
# time.sleep(1.0)
# ```
#
# A program spins a node by calling `rclpy.spin(node)`; our notebooks call `run(node)` instead. At first, we spin
# neither `sensor` nor `guard`. The black box spins all the time. After the `sleep`, which nodes have handled the five
# messages?
#
# - **a** None: without spinning, `sensor` sends nothing.
#   when `by_black_box == 0 and by_guard_before_spin == 0`
#   ✗ `publish` hands the message to DDS, which sends it whether or not the node is being spun.
# - **b** Only the black box. But if you spin `guard` later, it handles its five messages, too.
#   when `by_black_box == 5 and by_guard_before_spin == 0 and by_guard == 5`
#   ✓ The messages reached both nodes. Those for `guard` waited in its subscription's queue until you spun the node.
# - **c** The black box and `guard`: each callback runs as soon as its message arrives.
#   when `by_black_box == 5 and by_guard_before_spin == 5`
#   ✗ A message that arrives is put into a queue. Its callback runs only when a thread spins the node.
# - **d** Only the black box. The messages that arrived before you spun `guard` are lost.
#   when `by_black_box == 5 and by_guard_before_spin == 0 and by_guard < 5`
#   ✗ The guard's queue has room for ten messages. Only five arrived, so it dropped none.

# %%
from workbook.lesson import predict, reveal

predict("five-distances")

# %% [markdown]
# ## Run it
#
# Start the black box first. The second cell creates the other two nodes. The guard's callback appends each distance to
# a list.

# %%
from lesson_nodes import black_box

print("started", start(black_box))

# %%
import time

from rclpy.node import Node
from std_msgs.msg import Float32

from workbook.lesson import fresh, init

init()


class Sensor(Node):
    """Measures the distance to the wall. This one says what you tell it to."""

    def __init__(self) -> None:
        super().__init__("sensor")
        self.publisher = self.create_publisher(Float32, "/robot/distance", 100)


class Guard(Node):
    """Remembers every distance that it is told."""

    def __init__(self) -> None:
        super().__init__("guard")
        self.heard: list[float] = []
        self.create_subscription(Float32, "/robot/distance", self.on_distance, 10)

    def on_distance(self, message: Float32) -> None:
        self.heard.append(round(message.data, 1))


sensor, guard = fresh(Sensor), fresh(Guard)
print("the list of the guard:", guard.heard)

# %% [markdown]
# Programs need a moment to discover each other. So the next cell waits for both subscriptions before it publishes the
# five distances.
#
# [the same without helpers: start, init, fresh, run]

# %% id="nobody-spins"
from workbook.ros import topic_echo

while sensor.publisher.get_subscription_count() < 2:
    time.sleep(0.01)

for distance in (2.0, 1.6, 1.2, 0.8, 0.4):
    sensor.publisher.publish(Float32(data=distance))
time.sleep(1.0)

kept = (
    topic_echo("/black_box/kept", count=1, nodes=[]).messages[0].data
)  # nodes=[]: none of ours is spun
heard_before_spin = len(guard.heard)
print("kept by the black box:   ", kept)
print("callbacks of the guard:  ", len(guard.heard))

# %% [markdown]
# Now spin the guard:

# %%
from workbook.lesson import run

await run(guard, seconds=2)
print("callbacks of the guard:  ", len(guard.heard), guard.heard)
reveal(
    "five-distances",
    by_black_box=kept,
    by_guard_before_spin=heard_before_spin,
    by_guard=len(guard.heard),
)
stop()

# %% [markdown]
# ## Look inside
#
# Receiving and handling a message are two separate steps. First, the message **arrives**: DDS, which has its own
# threads, delivers it to your program. Later, the message is **handled**: your callback runs in your thread, while that
# thread is inside `spin`. In between, the message waits in a **queue**.
#
# A callback can take a second argument, which contains information *about* the message, such as the time when it was
# received. The guard below records that time, along with the time when its callback runs. The sensor is a separate
# program again, and it publishes every 0.2 s. For the first 1.5 s, we don't spin the guard. `watch_machine` records the
# steps between DDS and the callback.


# %% id="timed-guard"
from workbook.lesson import about, show_machine, watch_machine


class TimedGuard(Node):
    """Notes when each message was received, and when it was handled (s)."""

    def __init__(self) -> None:
        super().__init__("timed_guard")
        self.received: list[float] = []
        self.handled: list[float] = []
        self.create_subscription(Float32, "/robot/distance", self.on_distance, 10)

    def on_distance(self, message: Float32, info: dict) -> None:
        self.received.append(info["received_timestamp"] / 1e9)
        self.handled.append(time.time())


start(distance_sensor, period_s=0.2)
timed = fresh(TimedGuard)
with watch_machine(timed) as seen:
    time.sleep(1.5)
    spun_at = time.time()
    await run(timed, seconds=1.0)
stop()

received = sum(moment < spun_at for moment in timed.received)
handled = sum(moment < spun_at for moment in timed.handled)
in_queue = about(received, "messages", between=(4, 8), digits=1)
print("received before the spin:", in_queue)
print("handled before the spin: ", handled)

# %% [markdown]
# Play the recording. Each number is a message. Later lessons use this kind of diagram again.

# %% id="machine"
show_machine(
    seen,
    "numbered messages fill the queue one by one without a spin; then the executor "
    "takes them, the oldest first, and calls on_distance for each; later ones wait "
    "hardly at all",
)

# %% [markdown]
# Read the diagram from left to right. DDS puts each message into the **queue**, whether or not the node is being spun.
# Inside `spin`, the **executor** waits on the **wait set**, which lists the node's subscriptions, timers, and other
# sources of work. When a message is waiting, the executor takes the oldest one, and the spinning thread runs your
# callback. **Publishing and receiving don't need `spin`, but your callback does.**
#
# (If the message comes from another program, a DDS thread puts it into the queue. Within one program, Fast DDS does
# this during the call to `publish`.)
#
# `rclpy.spin(node)` is a loop: it takes a message from a queue, calls the callback, and repeats. It never runs two
# callbacks at the same time. So its callbacks need no locks, but a slow callback delays all the others. Messages for
# *one* subscription are handled in the order in which they arrived. Between different subscriptions, the order isn't
# guaranteed.

# %% [markdown]
# ### A myth, tested
#
# The official tutorial stores its subscription in an attribute, with the comment `# prevent unused variable warning`.
# The comment is about a linter's warning. But many people conclude that without the attribute, the garbage collector
# would remove the subscription. The guards above didn't store their subscriptions. The next cell runs the garbage
# collector and then publishes another distance:

# %% id="nothing-kept"
import gc

gc.collect()
sensor.publisher.publish(Float32(data=0.3))
await run(guard, seconds=5, until=lambda: 0.3 in guard.heard)
print("the guard still hears:", guard.heard[-1], "m")
print("subscriptions that its node keeps:", len(list(guard.subscriptions)))

# %% [markdown]
# The subscription still works, because the node keeps references to its subscriptions, publishers, and timers. Store a
# subscription yourself only if you want to remove it later with `self.destroy_subscription(self.subscription)`.

# %% [markdown] prediction="how-many-may-wait"
# ## Change it
#
# ### Experiment 1: the queue depth
#
# The last argument of `create_subscription` is the **subscription's queue depth**. Three readers subscribe to a camera,
# with queue depths of 1, 10, and 100. While the readers are busy, the camera publishes images 1 to 60. Then we spin the
# readers. Which images do they get?
#
# - **a** All three get images 51 to 60: older messages expire after a moment.
#   when `middle == 10 and deep == 10`
#   ✗ By default, waiting messages don't expire. How many messages a reader keeps depends only on its queue depth.
# - **b** Image 60, images 51 to 60, and all 60 images, respectively. New messages push out old ones.
#   when `shallow == 1 and middle == 10 and deep == 60 and first_of_middle == 51`
#   ✓ For each new message, a full queue drops its oldest one. A depth of 100 has room for all 60.
# - **c** Each of them gets all 60: once received, a message is never lost.
#   when `shallow == 60 and middle == 60 and deep == 60`
#   ✗ A queue keeps only as many messages as its depth allows. With a depth of 1, it keeps one.
# - **d** Image 1, images 1 to 10, and all 60 images, respectively. A full queue rejects new messages.
#   when `shallow == 1 and middle == 10 and deep == 60 and first_of_middle == 1`
#   ✗ A full queue drops its oldest message, not the new one. For a robot, the newest message is usually the most
#   useful.

# %%
predict("how-many-may-wait")

# %% id="depth"
from std_msgs.msg import Int32


class Camera(Node):
    """Says which picture it has just taken."""

    def __init__(self) -> None:
        super().__init__("camera")
        self.publisher = self.create_publisher(Int32, "/camera/picture_number", 100)


class Reader(Node):
    """Reads the numbers of pictures, from a queue of some depth."""

    def __init__(self, depth: int) -> None:
        super().__init__(f"reader_{depth}")
        self.depth = depth
        self.numbers: list[int] = []
        self.create_subscription(
            Int32, "/camera/picture_number", self.on_picture, depth
        )

    def on_picture(self, message: Int32) -> None:
        self.numbers.append(message.data)


camera = fresh(Camera)
readers = [fresh(Reader, depth) for depth in (1, 10, 100)]
while camera.publisher.get_subscription_count() < len(readers):
    time.sleep(0.01)

for number in range(1, 61):
    camera.publisher.publish(Int32(data=number))
await run(readers, seconds=3)

for reader in readers:
    span = f"{reader.numbers[0]} to {reader.numbers[-1]}"
    print(
        f"depth {reader.depth:>3}: {len(reader.numbers):>2} of 60, from number {span}"
    )
reveal(
    "how-many-may-wait",
    shallow=len(readers[0].numbers),
    middle=len(readers[1].numbers),
    deep=len(readers[2].numbers),
    first_of_middle=readers[1].numbers[0],
)
for reader in readers:
    reader.destroy_node()

# %%
from workbook.pictures.figures import figure, show

fig, axes = figure(6.4, 1.9)
for row, reader in enumerate(readers):
    lost = sorted(set(range(1, 61)) - set(reader.numbers))
    axes.plot(lost, [row] * len(lost), "x", color="#787878", alpha=0.6, markersize=4)
    axes.plot(
        reader.numbers, [row] * len(reader.numbers), "o", color="#208a3c", markersize=5
    )
axes.set(
    xlabel="number of the image", yticks=range(3), xlim=(0, 61), ylim=(-0.6, 2.6)
)
axes.set_title("A full queue drops its oldest messages (×)")
axes.set_yticklabels([f"depth {reader.depth}" for reader in readers])
axes.grid(axis="y", visible=False)
show(
    fig,
    "60 images: with depth 1 only the last is read, with depth 10 the last ten, "
    "with depth 100 all; x is lost",
)

# %% [markdown]
# A full queue drops its *oldest* message without a warning, so the newest message is always in the queue. The reader
# with depth 100 received all 60 images, so no message gets lost just because the node is busy. (The publisher's depth
# matters only for retransmission, so it makes no difference here.)
#
# **Your turn.** A camera takes 20 images a second, and a reader's queue should hold the images from the last 1.5 s.
# Choose the reader's depth. The cell publishes 60 images and checks the first one that the reader gets.

# %% id="your-depth"
from workbook.lesson import yours

depth = ...  # TODO: a whole number

first = ...
if depth is not ...:
    reader = fresh(Reader, depth)
    while camera.publisher.get_subscription_count() < 1:
        time.sleep(0.01)
    for number in range(1, 61):
        camera.publisher.publish(Int32(data=number))
    await run(reader, seconds=1)
    reader.destroy_node()
    first = reader.numbers[0]
yours(first, 31, "1.5 s at 20 images a second are 30 images: numbers 31 to 60.")

# %% [markdown] prediction="age-of-a-message"
# ### Experiment 2: the age of a message
#
# The distance sensor publishes every 0.05 s. A slow guard takes 0.2 s to handle each of its messages. Its queue depth
# is 50, and it runs for four seconds. How old is the last distance that it handles?
#
# - **a** More than a second, and the delay keeps growing.
#   when `last_age_s >= 1.0`
#   ✓ While the guard handles one message, four new ones arrive. So the queue keeps growing, and the message at its head
#   gets older and older.
# - **b** Less than 0.1 s: messages travel fast.
#   when `last_age_s < 0.1`
#   ✗ They do travel fast. But then each one waits in the queue until the guard has handled all earlier messages.
# - **c** About 0.2 s, the time to handle one message.
#   when `0.1 <= last_age_s < 1.0`
#   ✗ A single callback takes 0.2 s. But a message with ten others ahead of it waits for ten callbacks, which take 2 s.

# %%
predict("age-of-a-message")

# %% [markdown]
# The `info` argument also contains the time when the message was sent, in nanoseconds.
#
# **Your turn.** How old is this message when it's handled?

# %% id="your-age"
info = {"source_timestamp": 1_767_225_600_250_000_000}
handled_ns = 1_767_225_601_000_000_000  # what time.time_ns() returned

age_s = ...  # TODO: the age in seconds

yours(age_s, 0.75, "Subtract, then divide by 1e9: a second has 1e9 nanoseconds.")


# %%
class SlowGuard(Node):
    """Takes 0.2 s for each distance, and notes how old it was at the start."""

    def __init__(self, depth: int) -> None:
        super().__init__(f"slow_guard_{depth}")
        self.ages_s: list[float] = []
        self.travels_s: list[float] = []
        self.create_subscription(Float32, "/robot/distance", self.on_distance, depth)

    def on_distance(self, message: Float32, info: dict) -> None:
        self.ages_s.append((time.time_ns() - info["source_timestamp"]) / 1e9)
        self.travels_s.append(
            (info["received_timestamp"] - info["source_timestamp"]) / 1e9
        )
        time.sleep(0.2)


start(distance_sensor)
guards = {}
for depth in (50, 1):  # one after the other, so that they do not hold each other up
    guards[depth] = fresh(SlowGuard, depth)
    await run(guards[depth], seconds=4)
stop()
reveal("age-of-a-message", last_age_s=guards[50].ages_s[-1])

# %%
fig, axes = figure(6.4, 2.6)
for depth, look, color in ((50, "s--", "#b06a00"), (1, "o-", "#2f78d0")):
    ages = guards[depth].ages_s
    axes.plot(ages, look, markersize=4, color=color)
    axes.text(len(ages) - 0.5, ages[-1], f"depth {depth}", va="center")
axes.set(
    xlabel="callback",
    ylabel="age of its message (s)",
    xticks=range(0, 21, 5),
    xlim=(-1, 25),
)
axes.set_title("Messages get old in a deep queue, but stay fresh in a short one")
show(
    fig,
    "with depth 50 the messages grow older and older, up to seconds; with depth 1 "
    "all are fresh",
)

# %% id="message-age"
from statistics import median

deep, shallow = guards[50], guards[1]
fresh_ms, travel_ms = 1000 * median(shallow.ages_s), 1000 * median(deep.travels_s)
print("depth 50: the last distance was", about(deep.ages_s[-1], "s", between=(1, 4)))
print("depth  1: a distance was", about(fresh_ms, "ms", between=(0.1, 200)))
print("time from program to program:", about(travel_ms, "ms", between=(0.05, 100)))

# %% [markdown]
# Only a small part of a message's age is travel time. The rest is time in the queue. During each callback, one message
# leaves the queue and four new ones arrive. So the age grows until the queue is full and holds 2.5 s of messages (50
# times 0.05 s).
#
# Suppose the robot walks toward the wall at 1 m/s. Then a distance that's 2.5 s old is 2.5 m too large. With a depth of
# 1, the guard skips three out of every four distances, but each one that it handles is current. The right depth depends
# on the kind of message:
#
# | the message | depth | because |
# |---|---|---|
# | a state: distance, battery, camera image | small, 1 to 10 | only the newest message is useful |
# | an event: a button press, a command, a fault | large enough for the longest burst | every message counts |
#
# Changing the depth doesn't make a slow callback faster. Lesson 10 deals with slow callbacks.

# %% [markdown] prediction="wrong-hint"
# ### Experiment 3: what the type hint does
#
# In `on_distance(self, message: Float32)`, the hint names the message type. Suppose you copy the callback from another
# node, where the hint is `String`. The subscription's type is still `Float32`. What does the callback receive?
#
# - **a** Nothing: `create_subscription` raises an error, because the two types differ.
#   ✗ `create_subscription` checks the message type that you pass and the number of arguments that the callback takes.
#   It doesn't read hints.
# - **b** A `String` with the number as its text.
#   when `got == 'a String with a str'`
#   ✗ rclpy doesn't convert messages. The message has the type that you passed to `create_subscription`.
# - **c** A `Float32`, as if there were no hint.
#   when `got == 'a Float32 with a float'`
#   ✓ The first argument of `create_subscription` determines the type. Python doesn't check hints at run time.

# %%
predict("wrong-hint")

# %% id="wrong-hint"
from std_msgs.msg import String


class MixedUp(Node):
    """Its callback expects a text. The topic carries numbers."""

    def __init__(self) -> None:
        super().__init__("mixed_up")
        self.got: list[str] = []
        self.create_subscription(Float32, "/robot/distance", self.on_status, 10)

    def on_status(self, message: String) -> None:
        self.got.append(
            f"a {type(message).__name__} with a {type(message.data).__name__}"
        )


mixed_up = fresh(MixedUp)
sensor.publisher.publish(Float32(data=0.7))
await run(mixed_up, seconds=2)
got = mixed_up.got[0] if mixed_up.got else "nothing"
print("the callback got", got)
reveal("wrong-hint", got=got)

# %% [markdown]
# The first argument of `create_subscription` determines the message type. The type hint is for the code's readers: you,
# your editor, and mypy (lesson 07). If the callback had called `message.data.upper()`, the editor would have shown no
# error. But the program would have crashed with `'float' object has no attribute 'upper'`.

# %% [markdown]
# ## When it goes wrong
#
# **A callback without a message argument.** This node only counts messages, so its callback ignores their content.


# %% tags=["raises-exception"] id="no-argument"
class Counter(Node):
    """Counts distances."""

    def __init__(self) -> None:
        super().__init__("counter")
        self.count = 0
        self.create_subscription(Float32, "/robot/distance", self.on_distance, 10)

    def on_distance(self) -> None:
        self.count += 1


counter = fresh(Counter)

# %% [markdown]
# As the error message says, a callback takes either one argument (the message) or two (the message and its `info`).
# (`self` doesn't count.) So accept the message even if you ignore it: `def on_distance(self, message: Float32)`.
#
# **Wrong arguments to `create_subscription`.** The next three calls fail, too. Which error do you expect from each?


# %% id="three-calls"
def on_distance(message: Float32) -> None:
    """A callback as it should be."""


attempts = {
    "on_distance()": lambda: guard.create_subscription(
        Float32, "/robot/distance", on_distance(), 10
    ),
    "no depth": lambda: guard.create_subscription(
        Float32, "/robot/distance", on_distance
    ),
    "float": lambda: guard.create_subscription(
        float, "/robot/distance", on_distance, 10
    ),
}
for label, attempt in attempts.items():
    try:
        attempt()
    except (TypeError, AttributeError) as error:
        print(
            f"{label}\n    {type(error).__name__}:",
            str(error).split("This")[0].strip(),
        )

# %% [markdown]
# - `on_distance()` *calls* the function right away, without a message. Leave out the parentheses to pass the function
#   itself.
# - The missing `qos_profile` is the depth: how many messages can wait in the queue.
# - `float` is a Python type, but a topic carries messages such as `Float32`. (In the full error message, ignore the
#   part about ROS 1.)
#
# **A subscription with a different type.** The topic name is right, the robot is publishing, and the node is being
# spun. Yet the callback never runs.

# %% id="other-type"
from lesson_nodes import joint_position_publisher


class ArmWatcher(Node):
    """Counts the messages with joint angles."""

    def __init__(self, message_type: type) -> None:
        super().__init__("arm_watcher")
        self.heard = 0
        self.create_subscription(
            message_type, "/robot/joint_positions", self.on_angles, 10
        )

    def on_angles(self, message: object) -> None:
        self.heard += 1


start(joint_position_publisher)
watcher = fresh(ArmWatcher, Float32)
await run(watcher, seconds=2)
print("callbacks in two seconds:", watcher.heard)

# %% [markdown]
# The robot publishes twenty messages a second, but this subscription receives none. With Fast DDS, neither program gets
# an error or a warning.

# %%
from workbook.ros import topic_info

topic_info("/robot/joint_positions")

# %% [markdown]
# The robot publishes arrays, but this node subscribes to single numbers. DDS connects a publisher and a subscription
# only if both the topic name **and** the type match. So if you receive no messages, check three things: is the node
# being spun, is the name right, and is the type right? `topic_info` answers the last two questions. (Lesson 13 adds a
# fourth, about QoS.)
#
# **Your turn.** Make the watcher subscribe with the right type. The cell counts up to 20 calls of the watcher's
# callback.

# %% id="your-type"
message_type = ...  # TODO: import the class from std_msgs.msg, and put it here

heard = ...
if message_type is not ...:
    watcher = fresh(ArmWatcher, message_type)
    await run(watcher, seconds=3)
    heard = min(watcher.heard, 20)
stop()
yours(heard, 20, "topic_info shows the publisher's type.")

# %% [markdown]
# ## From a worked example to your own
#
# **Worked example.** A callback often handles messages from one topic and publishes to another. This brake node
# publishes a single `stop` when the wall comes within half a meter, and a single `go` when the way is clear again. To
# avoid repeating itself, it stores the last published word in an attribute.

# %%
STOP_BELOW_M = 0.5


class Brake(Node):
    """Says stop when the wall is close, and go when the way is free again."""

    def __init__(self) -> None:
        super().__init__("brake")
        self.last_word = "go"
        self.said: list[str] = []
        self.word_publisher = self.create_publisher(String, "/robot/walk", 10)
        self.create_subscription(Float32, "/robot/distance", self.on_distance, 10)

    def on_distance(self, message: Float32) -> None:
        word = "stop" if message.data < STOP_BELOW_M else "go"
        if word == self.last_word:
            return
        self.last_word = word
        self.said.append(word)
        self.word_publisher.publish(String(data=word))


brake = fresh(Brake)
distances = (1.5, 0.8, 0.4, 0.3, 0.4, 0.9, 1.6)
for distance in distances:
    sensor.publisher.publish(Float32(data=distance))
await run(brake, seconds=5, until=lambda: len(brake.said) == 2)
print(len(distances), "distances, and it said", brake.said)

# %% [markdown]
# **Fill in the blanks.** A motor's temperature sensor publishes on `/motor/temperature` (`Float32`, in °C). The node
# below stores the highest temperature so far. Replace each `...` with your code.

# %%
TOPIC = ...  # TODO: on which topic do the temperatures come?


class Thermometer(Node):
    """Remembers the highest temperature of the motor (°C)."""

    def __init__(self) -> None:
        super().__init__("thermometer")
        self.heard = 0
        self.highest = -273.15
        if TOPIC is not ...:
            ...  # TODO: a subscription to TOPIC that calls self.on_temperature

    def on_temperature(self, message: Float32) -> None:
        self.heard += 1
        # TODO: keep it in self.highest, if it is higher than all before


result = ...
if TOPIC is not ...:
    thermometer = fresh(Thermometer)
    motor = sensor.create_publisher(Float32, "/motor/temperature", 10)
    for celsius in (41.5, 63.0, 58.5):
        motor.publish(Float32(data=celsius))
    await run(thermometer, seconds=1)
    result = thermometer.heard, thermometer.highest
yours(result, (3, 63.0), "Three messages come, and the highest is 63.0 °C.")

# %% [markdown]
# **Your own.** In the [exercise](../exercises/04_subscriptions_and_callbacks.ipynb), you write a battery monitor. The
# judge sends it about fifty readings, both good and bad, and compares them with the messages that your node publishes.

# %% [markdown]
# ## Check yourself
#
# **1. A program creates a node, calls a method that publishes, and then sleeps. It never spins the node. What works?**
#
# <details><summary>a) Nothing: without spinning, the node isn't connected</summary>
#
# ✗ DDS connects nodes in its own threads. You saw that the black box received all five messages.
#
# </details>
# <details><summary>b) Publishing works, and callbacks run, just more slowly</summary>
#
# ✗ Callbacks run in your thread, inside `spin`. While that thread sleeps, it can't run any.
#
# </details>
# <details><summary>c) Publishing works, but callbacks don't run</summary>
#
# ✓ Messages for the node wait in the subscription's queue, up to its depth.
#
# </details>
#
# **2. A subscription has a queue depth of 10. While its node is busy, 25 messages arrive within a second. What happens to them?**
#
# <details><summary>a) rclpy raises an error, because the queue has overflowed</summary>
#
# ✗ The queue drops its oldest message without an error or a warning. If every message counts, choose a larger depth.
#
# </details>
# <details><summary>b) The callback gets the first 10; the others are dropped, because the queue is full</summary>
#
# ✗ It's the other way around: the newest message always gets in.
#
# </details>
# <details><summary>c) The callback gets all 25, just late</summary>
#
# ✗ That would take a depth of 25 or more.
#
# </details>
# <details><summary>d) The callback gets the last 10, beginning with the oldest of them</summary>
#
# ✓ Each new message replaced the oldest one. The callback gets the remaining ones in the order in which they were sent.
#
# </details>
#
# **3. What's wrong with `self.create_subscription(Float32, "/robot/distance", self.on_distance(), 10)`?**
#
# <details><summary>a) The 10 should be a QoSProfile</summary>
#
# ✗ A number works, too. It sets the depth, and all other settings keep their defaults.
#
# </details>
# <details><summary>b) It calls the method instead of passing it</summary>
#
# ✓ Leave out the parentheses. With them, Python calls the method right away, without a message.
#
# </details>
# <details><summary>c) The result has to be stored in an attribute</summary>
#
# ✗ The node stores it. In this lesson, you ran the garbage collector, and the subscription still worked.
#
# </details>
#
# **4. A callback receives a `Float32` and needs to know when it was sent. Where does it find that time?**
#
# <details><summary>a) In the callback's second argument: <code>info["source_timestamp"]</code></summary>
#
# ✓ rclpy passes `info` to every callback that takes two arguments. The time is in nanoseconds.
#
# </details>
# <details><summary>b) In the message's header: <code>message.header.stamp</code></summary>
#
# ✗ Only messages with a header have a stamp. `Float32` has no header; its only field is `data`.
#
# </details>
# <details><summary>c) From the clock: <code>time.time()</code> in the callback's first line</summary>
#
# ✗ That's the time when the message is handled. By then, the message may have waited in the queue for seconds.
#
# </details>

# %% [markdown]
# ## Talk it through
#
# Write down your own answer first. Then give this prompt to an AI assistant, or discuss it with a colleague.
#
# ```text
# I'm programming a robot with ROS 2 Jazzy in Python (rclpy). My robot has one node that
# subscribes to a camera (30 images a second, my callback takes 80 ms), to an emergency
# button (one message when it is pressed), and to its battery (one message every 2 s).
# All three subscriptions have a depth of 10. What will go wrong, and which depths would
# you choose? Make sure that every rclpy function you use exists in Jazzy.
# ```
#
# <details><summary>What a good answer covers</summary>
#
# The camera sends 30 images a second, but the node can handle only 12, so the camera's queue is always full. Each image
# that the callback gets is the oldest of the last ten, so it's a third of a second old. With a depth of 1, the image is
# as fresh as possible. The node then skips images, but that's fine, because only the newest one is useful.
#
# A button press is an event, so it must not be lost. A depth of 10 is enough: the button has its own queue, so images
# can't push out its messages. But the callbacks run one after another, so the button's callback may run 80 ms late or
# more. Changing the depth doesn't help. For the battery, a depth of 1 is enough.
#
# In a good answer, the button's callback runs in a different thread from the camera's (lesson 10), or in a separate
# program. The answer also warns that an emergency stop shouldn't depend on a topic alone.
#
# </details>
#
# <details><summary>What to check in the reply</summary>
#
# Watch for these two claims. We tested both with the rclpy version that this course uses, and both are wrong.
#
# - **When the queue is full, the new message is dropped:** No, the oldest message is dropped, and the new one joins the
#   queue.
# - **Each subscription has its own thread:** No, `rclpy.spin` runs all of a node's callbacks in one thread, one after
#   another.
#
# </details>

# %% [markdown]
# ## Take away
#
# - After `create_subscription(type, topic, callback, depth)`, rclpy calls the callback once for each message, in the
#   order of arrival.
# - Publishing and receiving don't need `spin`, but callbacks do. Without it, they don't run, and you get no error.
# - Up to `depth` messages wait in the queue. When it's full, each new message replaces the oldest. Choose a small depth
#   for states and a large one for events.
# - The type that you pass to `create_subscription` determines the message type; the type hint doesn't. If the type or
#   the topic name doesn't match the publisher's, no message arrives. `topic_info` shows both.
# - Pass the callback without parentheses. The node stores the subscription, so you don't have to.
#
# **Before:** [03 · Publishers and messages](03_publishers_and_messages.ipynb)
#
# **Next:** [05 · Timers](05_timers.ipynb), for work that a robot repeats.
#
# **More:** [Writing a simple publisher and
# subscriber](https://docs.ros.org/en/jazzy/Tutorials/Beginner-Client-Libraries/Writing-A-Simple-Py-Publisher-And-Subscriber.html),
# step by step, and [quality of
# service](https://docs.ros.org/en/jazzy/Concepts/Intermediate/About-Quality-of-Service-Settings.html), which explains
# the depth.
