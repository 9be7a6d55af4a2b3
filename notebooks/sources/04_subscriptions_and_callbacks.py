# %% [markdown]
# # 04 · Subscriptions and callbacks
#
# A robot that only publishes walks into walls. To react to its own sensors, it subscribes, and says what to do with each
# message that comes.
#
# - **Minutes:** 45
# - **You need:** lessons [00](00_start_here.ipynb) to 03: a node, a publisher, a message
# - **You will be able to:**
#   - subscribe to a topic, and write the callback that handles its messages
#   - say when it is called and when it is not
#   - choose the depth of a subscription
#   - tell how old a message is
# - **Left out:** repeating work (lesson 05), the steps inside `spin` (06), long work in a callback (10), most
#   settings of a connection (13)

# %% [markdown]
# Watch the robot. It walks up to a wall and away from it, again and again. One program measures how far the wall is,
# twenty times a second. The other one subscribes, and raises the robot's arms when the wall comes close.

# %%
from lesson_nodes import careful_robot, distance_sensor
from workbook.lesson import start, stop, watch_robot

print("started", start(distance_sensor), "and", start(careful_robot, close_m=1.2))
await watch_robot(seconds=8, ease=0.1)
stop()

# %% [markdown]
# The second program has no timer and no loop. It acts only when a message comes:
#
# ```python
# self.create_subscription(Float32, "/robot/distance", self.on_distance, 10)
#
# def on_distance(self, message: Float32) -> None:
#     joints = posture(message.data, self.close_m)
#     self.joint_publisher.publish(Float32MultiArray(data=joints))
# ```
#
# The first line is the **subscription**: which type, which topic, what to call, and a *depth* (Experiment 1). The method
# is the **callback**: you write it, and rclpy calls it, once for each message. Set `close_m` to `2.5` above and run the
# cell again.

# %% [markdown] prediction="five-distances"
# ## Predict
#
# Now you take the sensor's place. Two nodes in this notebook: `sensor` has a publisher, `guard` has a subscription. A
# third node, the black box, is a program of its own. It listens, too, and counts.
#
# ```python
# for distance in (2.0, 1.6, 1.2, 0.8, 0.4):
#     sensor.publisher.publish(Float32(data=distance))
# time.sleep(1.0)
# ```
#
# Programs call `rclpy.spin(node)`, notebooks `run(node)`. Here, neither `sensor` nor `guard` is spun. The black box spins,
# as a program should. After that second, which nodes have handled the five messages?
#
# - **a** None: publishing needs spin, so nothing was sent.
#   when `by_black_box == 0 and by_guard_before_spin == 0`
#   ✗ `publish` hands the message to DDS, which sends it from threads of its own. It needs no spin.
# - **b** Only the black box. When `guard` is spun later, it handles its five, too.
#   when `by_black_box == 5 and by_guard_before_spin == 0 and by_guard == 5`
#   ✓ The messages arrived at both. They waited in the queue of `guard` until it was spun.
# - **c** Both: a callback is called as soon as its message arrives.
#   when `by_black_box == 5 and by_guard_before_spin == 5`
#   ✗ A message that arrives goes into a queue. Its callback runs later, in a thread that spins the node.
# - **d** Only the black box. What came while `guard` did not spin is lost.
#   when `by_black_box == 5 and by_guard_before_spin == 0 and by_guard < 5`
#   ✗ The queue of `guard` has room for ten messages, and only five came. None was pushed out.

# %%
from workbook.lesson import predict, reveal

predict("five-distances")

# %% [markdown]
# ## Run it
#
# First the black box, then the two nodes. The callback of `guard` keeps what it gets in a list, so that we can look.

# %%
from lesson_nodes import black_box

print("started", start(black_box))

# %%
import time

from rclpy.node import Node
from std_msgs.msg import Float32

from workbook.lesson import fresh, init

init()  # rclpy.init(), made so that a cell can be run again


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
# It takes a moment until two programs have found each other. So we wait until the publisher knows of two subscriptions:
# that of `guard`, and that of the black box. Then we publish the five distances.

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
# Now we spin the guard:

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
# Two things happened that look like one. First, messages **arrive**: DDS has threads of its own that send and receive.
# Second, messages are **handled**: your callback runs, in your thread, while that thread is inside `spin`. Between the two
# there is a **queue**.
#
# A callback may take a second argument, with what rclpy knows *about* the message, such as when it was received. This guard
# notes that time, and the time of its callback. The sensor is again a program of its own, and publishes every 0.2 s. For 1.5 s
# nobody spins the guard. `watch_machine` notes what happens between DDS and its callback.


# %% id="timed-guard"
from workbook.lesson import show_machine, watch_machine


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

received = [moment < spun_at for moment in timed.received]
handled = [moment < spun_at for moment in timed.handled]
print("several were received before anybody spun:", sum(received) > 3)
print("callbacks before anybody spun:            ", sum(handled))

# %% [markdown]
# Here is that recording, played back. It is the **machine** that you will meet again in later lessons. Each number is a message.

# %% id="machine"
show_machine(
    seen,
    "numbered messages fill the queue one by one while nobody spins; then the executor "
    "takes them, the oldest first, and calls on_distance for each; later ones wait "
    "hardly at all",
)

# %% [markdown]
# Read it from left to right. DDS puts each message into the **queue**, spin or no spin. Inside `spin`, the **executor** waits
# in the **wait set**, the list of all that can become ready. It takes the oldest message, and its thread runs your callback.
# **Publish needs no spin. Receiving needs no spin. Your callback does.**
#
# (If the message comes from another program, a thread of DDS puts it into the queue. Within one program, Fast DDS
# does so inside the call of `publish`.)
#
# `rclpy.spin(node)` is a loop: take a waiting message out of a queue, call its callback, repeat. It runs one callback at a
# time, never two at once. Messages of *one* subscription are handled in the order in which they came. Between different
# subscriptions no order is promised. So you need no locks in such a node, and a slow callback delays all others.

# %% [markdown]
# ### A myth, tested
#
# The official tutorial writes `self.subscription = self.create_subscription(...)`, and below it
# `self.subscription  # prevent unused variable warning`. That comment is about a warning of linters. Many readers take it
# for a rule: keep it, or the garbage collector removes the subscription. The guards above kept nothing. We run the
# collector:

# %% id="nothing-kept"
import gc

gc.collect()
sensor.publisher.publish(Float32(data=0.3))
await run(guard, seconds=5, until=lambda: 0.3 in guard.heard)
print("the guard still hears:", guard.heard[-1], "m")
print("subscriptions that its node keeps:", len(list(guard.subscriptions)))

# %% [markdown]
# The node keeps its subscriptions, publishers and timers. Keep one yourself if you want to end it later, with
# `self.destroy_subscription(self.subscription)`.

# %% [markdown] prediction="how-many-may-wait"
# ## Change it
#
# ### Experiment 1: how many may wait
#
# The last argument of `create_subscription` is the **subscription's queue depth**. A camera publishes 60 pictures, numbered
# from 1 to 60, while three readers are busy. Their depths are 1, 10 and 100. Then they are spun. What do they get?
#
# - **a** Numbers 51 to 60, for all three: the rest is gone after a moment.
#   when `middle == 10 and deep == 10`
#   ✗ There is no time limit on waiting. What is kept depends on the depth of each reader alone.
# - **b** Number 60, numbers 51 to 60, and all 60: what is new pushes out what is old.
#   when `shallow == 1 and middle == 10 and deep == 60 and first_of_middle == 51`
#   ✓ A full queue drops its oldest message for each new one. With depth 100 there was room for all 60.
# - **c** All 60, each of them: a message that was received is never lost.
#   when `shallow == 60 and middle == 60 and deep == 60`
#   ✗ Received messages are kept only as far as the depth allows. A reader with depth 1 keeps one.
# - **d** Number 1, numbers 1 to 10, and all 60: what comes when the queue is full is turned away.
#   when `shallow == 1 and middle == 10 and deep == 60 and first_of_middle == 1`
#   ✗ It is the oldest message that has to go, not the newest. A robot cares more for what is new.

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
    xlabel="number of the picture", yticks=range(3), xlim=(0, 61), ylim=(-0.6, 2.6)
)
axes.set_title("a full queue drops its oldest messages (×)")
axes.set_yticklabels([f"depth {reader.depth}" for reader in readers])
axes.grid(axis="y", visible=False)
show(
    fig,
    "60 pictures: with depth 1 only the last is read, with depth 10 the last ten, "
    "with depth 100 all; x is lost",
)

# %% [markdown]
# Nothing warns you. A full queue drops its *oldest* message, so the newest is always in it. All 60 pictures reached the
# reader with depth 100, although it was busy. Messages are not lost just because no callback runs.
#
# The publisher has a queue depth as well, for retransmission; the deeper notebook of lesson 03 measures it. Here the
# camera's publisher has a depth of 100, so that it makes no difference.

# %% [markdown] prediction="age-of-a-message"
# ### Experiment 2: how old is a message
#
# The distance sensor publishes every 0.05 s. Handling a message takes this guard 0.2 s. It has a depth of 50, and works
# for four seconds. How old is the last distance that it handles?
#
# - **a** More than a second, and it gets worse.
#   when `last_age_s >= 1.0`
#   ✓ Four messages come in the time that one is handled. The queue grows, and with it the age of the message at its
#   head.
# - **b** Less than 0.1 s: messages travel fast.
#   when `last_age_s < 0.1`
#   ✗ They do travel fast. But then each one waits in the queue until all that came before it are handled.
# - **c** About 0.2 s, the time that one takes.
#   when `0.1 <= last_age_s < 1.0`
#   ✗ 0.2 s is what one callback takes. A message that waits behind ten others waits ten times as long.

# %%
predict("age-of-a-message")

# %% [markdown]
# `info` says when the message was sent, in nanoseconds. Its age is the time now, minus that.


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
axes.set_title("in a deep queue, messages grow old")
show(
    fig,
    "with depth 50 the messages grow older and older, up to seconds; with depth 1 "
    "all are fresh",
)

# %% id="message-age"
from statistics import median

deep, shallow = guards[50], guards[1]
print("depth 50: the last distance was older than a second:", deep.ages_s[-1] > 1.0)
print(
    "depth  1: half of them were younger than 0.2 s:     ", median(shallow.ages_s) < 0.2
)
print(
    "of that, time on the way was less than 0.1 s:       ", median(deep.travels_s) < 0.1
)

# %% [markdown]
# Travel takes about a millisecond. The rest is waiting: each callback takes out one message, while four new ones come in.
# The age grows until the queue is full, up to 50 messages times 0.05 s, which is 2.5 s.
#
# A robot that walks 1 m/s then believes that the wall is more than two meters further away than it is. With a depth of 1
# it skips three of four distances, and knows where it is. Which is right depends on the message:
#
# | the message | depth | because |
# |---|---|---|
# | a state: distance, battery, camera picture | small, 1 to 10 | only the newest one is of use |
# | an event: a button, an order, a fault | large enough for the longest burst | each one counts |
#
# No depth makes a slow callback fast. Lesson 10 shows what to do about that.

# %% [markdown] prediction="wrong-hint"
# ### Experiment 3: what the type hint does
#
# In `on_distance(self, message: Float32)` the hint says what will come. You copy the callback of another node, and its
# hint says `String`. The subscription still says `Float32`. What will the callback get?
#
# - **a** Nothing: `create_subscription` raises an error, because the two do not fit.
#   ✗ `create_subscription` looks at the type that it is given, and at how many arguments the callback takes. It does
#   not read hints.
# - **b** A `String` with the number as its text.
#   when `got == 'a String with a str'`
#   ✗ Nothing is converted. The message keeps the type that the subscription has asked for.
# - **c** A `Float32`, as if the hint were not there.
#   when `got == 'a Float32 with a float'`
#   ✓ The first argument of `create_subscription` decides. Python does not check a hint when the program runs.

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
# The first argument of `create_subscription` decides what comes. The hint is for readers: you, your editor, and mypy in
# lesson 07. Had the callback called `message.data.upper()`, the editor would have agreed, and the program would have ended
# with `'float' object has no attribute 'upper'`.

# %% [markdown]
# ## When it goes wrong
#
# **A callback that takes nothing.** This one only wants to count.


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
# The error is clear: a callback has one argument, the message, or two, the message and what is known about it. (`self` is
# not counted.) Take the message, even if you do not use it: `def on_distance(self, message: Float32)`.
#
# **Parentheses, and things forgotten.** Three more calls that do not work. What does each of them say?


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
# - `on_distance()` *calls* the function, now, without a message. Without the parentheses you pass the function itself.
# - `qos_profile` is the depth: say how many may wait, mostly `10`.
# - `float` is a type of Python. A topic carries messages: `Float32`. (The rest of the error speaks of ROS 1. Ignore it.)
#
# **Silence.** The names are right, the robot publishes, the node is spun, and no message comes.

# %% id="other-type"
from std_msgs.msg import Float32MultiArray

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
# Twenty messages a second, and not one callback. With Fast DDS, as here, neither side gets an error or a warning.

# %%
from workbook.ros import topic_info

topic_info("/robot/joint_positions")

# %% [markdown]
# The robot publishes arrays, and this node expects single numbers. Two programs are connected only if name **and** type are
# the same. So when no message comes, ask three things: is my node spun? Is the name right? Is the type right? `topic_info`
# answers the last two.

# %%
watcher = fresh(ArmWatcher, Float32MultiArray)
await run(watcher, seconds=5, until=lambda: watcher.heard == 20)
print("callbacks with the right type:", watcher.heard)
stop()

# %% [markdown]
# Within *one* program rclpy refuses a second type on a topic, as you saw in lesson 03.

# %% [markdown]
# ## From a worked example to your own
#
# **Worked.** A callback often handles one topic and publishes on another. This one brakes. It publishes `stop` when the wall
# is closer than half a meter, and `go` when the way is free again, each of them once. So it must remember what it published
# last, in an attribute.

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
# **Faded.** A motor has a temperature sensor on `/motor/temperature` (`Float32`, in °C). The node below keeps the
# highest temperature so far. Fill in what is `...`. Until then the cell runs, and says what is missing.

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


if TOPIC is ...:
    print(
        "Fill in the topic, the subscription and the callback, then run this cell "
        "again."
    )
else:
    thermometer = fresh(Thermometer)
    motor = sensor.create_publisher(Float32, "/motor/temperature", 10)
    for celsius in (41.5, 63.0, 58.5):
        motor.publish(Float32(data=celsius))
    await run(thermometer, seconds=1)
    print(
        thermometer.heard,
        "of 3 messages, the highest was",
        thermometer.highest,
        "and should be 63.0",
    )

# %% [markdown]
# **Your own.** In the [exercise](../exercises/04_subscriptions_and_callbacks.ipynb) you write a battery monitor. The
# judge sends it about fifty readings, good and bad ones, and compares them with what your node publishes.

# %% [markdown]
# ## Check yourself
#
# **1. A program makes a node, calls a method of it that publishes, and sleeps. It never spins. What works?**
#
# <details><summary>a) Nothing: without spin the node is not connected</summary>
#
# ✗ Connecting is the work of DDS, in threads of its own. You have seen the black box get all five.
#
# </details>
# <details><summary>b) Publishing works and callbacks run, only more slowly</summary>
#
# ✗ Callbacks run in your thread, inside `spin`. A thread that sleeps runs none.
#
# </details>
# <details><summary>c) Publishing works, callbacks do not run</summary>
#
# ✓ Yes. What comes for the node waits in its queue, up to the depth.
#
# </details>
#
# **2. A subscription has depth 10. While its node is busy for a second, 25 messages come. What then?**
#
# <details><summary>a) rclpy raises an error: the queue has overflowed</summary>
#
# ✗ The queue drops its oldest message, without an error or a warning. If each message counts, choose a depth that is
# large enough.
#
# </details>
# <details><summary>b) The callback gets the first 10; the others found the queue full</summary>
#
# ✗ The other way around: the newest message always gets in.
#
# </details>
# <details><summary>c) All 25 come, only late</summary>
#
# ✗ That takes a depth of 25 or more.
#
# </details>
# <details><summary>d) The callback gets the last 10, the oldest of them first</summary>
#
# ✓ The new ones have pushed out the old ones. What is left comes in the order in which it was sent.
#
# </details>
#
# **3. `self.create_subscription(Float32, "/robot/distance", self.on_distance(), 10)`: what is wrong?**
#
# <details><summary>a) The 10 should be a QoSProfile</summary>
#
# ✗ A number is fine: it is the depth, and everything else keeps its default.
#
# </details>
# <details><summary>b) It calls the method instead of passing it</summary>
#
# ✓ Leave the parentheses out. With them, Python calls it at once, and the message is missing.
#
# </details>
# <details><summary>c) The result has to be kept in an attribute</summary>
#
# ✗ The node keeps it. In this lesson you ran the garbage collector, and the subscription stayed.
#
# </details>
#
# **4. A callback gets a `Float32` and must know when it was sent. Where does it find that?**
#
# <details><summary>a) In a second argument of the callback: <code>info["source_timestamp"]</code></summary>
#
# ✓ rclpy passes it to each callback that takes two arguments. The number is in nanoseconds.
#
# </details>
# <details><summary>b) In the header of the message: <code>message.header.stamp</code></summary>
#
# ✗ Only messages with a header have it, and `Float32` has none. Its only field is `data`.
#
# </details>
# <details><summary>c) In the clock: <code>time.time()</code> in the first line of the callback</summary>
#
# ✗ That is the time at which it is handled. Before that, it may have waited in the queue for seconds.
#
# </details>

# %% [markdown]
# ## Talk it through
#
# Copy the prompt for an AI assistant, or discuss it with a colleague. State your own view first.
#
# ```text
# I program a robot with ROS 2 Jazzy in Python (rclpy). My robot has one node that
# subscribes to a camera (30 pictures a second, my callback takes 80 ms), to an
# emergency button (one message when it is pressed), and to its battery (one message
# every 2 s). All three have a depth of 10. What will go wrong, and which depths would
# you choose? Name only functions that exist in rclpy for Jazzy.
# ```
#
# <details><summary>What a good answer contains</summary>
#
# The node handles 12 pictures a second and gets 30, so the camera's queue is always full. The picture that is handled
# is the oldest of the last ten, a third of a second old. With a depth of 1 it is as fresh as can be. Pictures are
# skipped then, but only the newest one is of use. The button is an event, and no press may be lost. A depth of 10 is
# fine: the button has its own queue, which pictures cannot fill. But all callbacks run one after another, so the
# callback of the button may run 80 ms late or more. No depth changes that. For the battery, 1 is enough. In a good
# answer, the button does not share a thread with the camera (lesson 10), or has a node of its own. And a button that
# must stop the robot is not left to a topic alone.
#
# </details>
#
# <details><summary>What to check in the reply</summary>
#
# Two claims you may meet. Both are wrong: each was tried with the rclpy of this course.
#
# - **When the queue is full, the new message is dropped:** The oldest one is. The newest messages wait.
# - **Each subscription has a thread of its own:** `rclpy.spin` runs all callbacks of a node in one thread, one after
#   another.
#
# </details>

# %% [markdown]
# ## Take away
#
# - `create_subscription(type, topic, callback, depth)`: rclpy calls the callback for each message, in the order in
#   which they came.
# - Publishing and receiving need no spin. Callbacks do: no spin, no callback, and no error either.
# - Up to `depth` messages wait; each further one pushes out the oldest. Choose a small depth for a state, and a large
#   one for an event.
# - The first argument decides which type comes, not the hint. With another type or name, no message comes. Ask
#   `topic_info`.
# - Hand over the callback without parentheses. The node keeps the subscription; you need not.
#
# **Before:** [03 · Publishers and messages](03_publishers_and_messages.ipynb)
#
# **Next:** [05 · Timers](05_timers.ipynb), for what a robot does again and again.
#
# **More:** [Writing a simple publisher and
# subscriber](https://docs.ros.org/en/jazzy/Tutorials/Beginner-Client-Libraries/Writing-A-Simple-Py-Publisher-And-Subscriber.html),
# step by step, and [quality of
# service](https://docs.ros.org/en/jazzy/Concepts/Intermediate/About-Quality-of-Service-Settings.html), which covers
# the depth.
