# %% [markdown]
# # 11 · Polling and callbacks
#
# A robot hand closes around an egg and has to stop when it touches the shell. Should the program poll for the touch, or
# should a callback report it?
#
# - **Minutes:** 45
# - **You need:** lessons [05](05_timers.ipynb) and [10](10_slow_callbacks.ipynb)
# - **You will be able to:**
#   - recognize polling and callbacks in a program
#   - compare their latency, missed messages, and CPU time
#   - replace a polling loop with callbacks
# - **Not covered:** choosing a queue depth (lesson 13), and real-time systems

# %% [markdown]
# **Polling** means checking again and again whether something has happened. With a **callback**, your code doesn't have
# to check: rclpy calls the callback when a message arrives.
#
# The following robot uses both approaches. The sensor in its hand numbers each touch and publishes the number. Two
# monitors report the touches: one polls, and the other uses a callback.

# %%
from lesson_nodes import callback_monitor, polling_monitor, touch_sensor
from workbook.lesson import graph_picture, start, stop

print("started", start(touch_sensor, listeners=3))
print("started", start(polling_monitor))
print("started", start(callback_monitor))
graph_picture("/robot/touch")

# %%
stop()

# %% [markdown] prediction="the-touches"
# ## Predict
#
# Many beginners ask why they can't just write a loop. Here are both monitors, shortened:
#
# ```python
# # A: a loop that polls                         # B: a callback
# def keep(message):                             def on_touch(message):
#     monitor.last = message.data                    report(message.data)
#
# Thread(target=spin, args=(monitor,)).start()   node.create_subscription(
# while rclpy.ok():                                  Int32, "/robot/touch", on_touch, 100)
#     if monitor.last != monitor.reported:       rclpy.spin(node)
#         monitor.reported = monitor.last
#         report(monitor.reported)
#     time.sleep(0.05)
# ```
#
# In A, a second thread spins the node, so rclpy calls `keep` for each touch. The loop itself only polls.
#
# The hand grips one object after another, and a grip can cause several touches. So the touches come in bunches: after
# each pause, up to six arrive at almost the same moment. In about five seconds, there are 120 touches, and A polls
# about 100 times. How many of the 120 touches does A report?
#
# - **a** Fewer than half.
#   when `reported < sent / 2`
#   ✓ The loop finds only the last touch of each bunch, because each touch overwrites the one before it.
# - **b** About 100: one per poll.
#   when `sent / 2 <= reported < sent`
#   ✗ The loop does poll about 100 times. But most polls happen during a pause, so they find nothing new.
# - **c** All 120, some of them a little late.
#   when `reported == sent`
#   ✗ `monitor.last` stores only one touch. If several touches arrive between two polls, only the last one is left.

# %%
from workbook.lesson import predict, reveal

predict("the-touches")

# %% [markdown]
# ## Run it
#
# A referee node subscribes to the touches and to both monitors' reports. Each message carries the time at which it was
# sent. If a callback takes a second argument, rclpy passes a dictionary with information about the message, including
# this timestamp. So the referee can compute each report's delay, no matter how busy the referee itself is.
#
# [the same without helpers: start, init, fresh, run]

# %%
from rclpy.node import Node
from std_msgs.msg import Int32

from workbook.lesson import about, fresh, init, run

TOUCHES = 120


class Referee(Node):
    """Notes when each touch was sent by the hand, and when by each monitor (in ms)."""

    def __init__(self) -> None:
        super().__init__("referee")
        self.touched: dict[int, float] = {}
        self.polling: list[tuple[int, float]] = []
        self.callback: list[tuple[int, float]] = []
        self.create_subscription(Int32, "/robot/touch", self.on_touch, 200)
        self.create_subscription(Int32, "/monitor/by_polling", self.on_polling, 200)
        self.create_subscription(Int32, "/monitor/by_callback", self.on_callback, 200)

    def on_touch(self, message: Int32, info: dict) -> None:
        self.touched[message.data] = info["source_timestamp"] / 1e6

    def on_polling(self, message: Int32, info: dict) -> None:
        self.polling.append((message.data, info["source_timestamp"] / 1e6))

    def on_callback(self, message: Int32, info: dict) -> None:
        self.callback.append((message.data, info["source_timestamp"] / 1e6))

    def late(self, reports):
        """How late each report was (ms)."""
        return [moment - self.touched[number] for number, moment in reports]


async def match(touches=TOUCHES, **polling):
    """Both monitors at work, until the hand has been touched so many times."""
    init()
    referee = fresh(Referee)
    start(polling_monitor, **polling)
    start(callback_monitor)
    start(touch_sensor, touches=touches, listeners=3)
    await run(
        referee,
        seconds=40,
        until=lambda: len(referee.touched) == len(set(referee.callback)) == touches,
    )
    await run(referee, seconds=0.5)  # for late reports
    stop()
    return referee


first = await match(poll_s=0.05)
print("touches:", len(first.touched))
reveal("the-touches", reported=len(first.polling), sent=TOUCHES)

# %% id="missed"
from statistics import median


def typical(of, name, between):
    """The median delay of one monitor's reports, as text."""
    return about(median(of.late(getattr(of, name))), "ms", between=between)


found = about(len(first.polling), between=(12, 60))
print(f"by polling:  {found} of {TOUCHES} touches reported")
print(f"by callback: {len(first.callback)} of {TOUCHES} touches reported")
print("typical delay by polling: ", typical(first, "polling", (10, 100)))
print("typical delay by callback:", typical(first, "callback", (0.1, 20)))

# %% [markdown]
# ## Look inside
#
# The next plot shows the first 1.5 seconds. Touches in the same bunch are stacked vertically.

# %%
from workbook.pictures.figures import figure, show
from workbook.pictures.palette import BLUE, GREEN, GREY, RED

zero = first.touched[1]
touched_at = {
    number: (moment - zero) / 1000 for number, moment in first.touched.items()
}
rows = {
    "touches": set(touched_at),
    "by polling": {number for number, _ in first.polling},
    "by callback": {number for number, _ in first.callback},
}

fig, axes = figure(6.4, 2.3)
for row, numbers in enumerate(rows.values()):
    for number, at in touched_at.items():
        bunch = [other for other in touched_at if abs(touched_at[other] - at) < 0.02]
        height = 0.14 * (bunch.index(number) - (len(bunch) - 1) / 2) - row
        marker, color = "o", BLUE if row == 0 else GREEN
        if number not in numbers:
            marker, color = "x", RED
        axes.plot(at, height, marker=marker, color=color, markersize=4)
axes.set(xlim=(-0.03, 1.5), ylim=(-2.6, 0.6), xlabel="s")
axes.set_yticks([0, -1, -2], list(rows))
axes.set_title("Polling misses most touches of a bunch")
axes.grid(visible=False)
show(
    fig,
    "touches in bunches; by polling most of a bunch is missed (a cross), "
    "by callback each one is reported (a dot)",
)

# %% [markdown]
# A cross marks a touch that the monitor didn't report. The polling monitor stores only *the last* touch: if five arrive
# between two polls, `monitor.last` contains the fifth. So each poll finds at most one touch, and even that one late.
#
# The time from an event to the reaction is called **latency**. The next plot shows each report's latency on a
# logarithmic axis: 1 to 10 ms takes up as much space as 10 to 100 ms.

# %%
import numpy as np

fig, axes = figure(6.4, 2.6)
edges = np.logspace(-1, 2, 37)
axes.hist(first.late(first.callback), bins=edges, color=GREEN, alpha=0.85)
axes.hist(first.late(first.polling), bins=edges, color=RED, alpha=0.6, hatch="//")
axes.axvline(50, linestyle="--", color=GREY)
axes.set(xscale="log", xlabel="late by (ms)", ylabel="reports", xlim=(0.1, 1000))
axes.set_xticks([0.1, 1, 10, 50, 100], ["0.1", "1", "10", "50", "100"])
bold = {"transform": axes.transAxes, "weight": "bold"}
axes.text(0.02, 0.9, "by callback", color=GREEN, **bold)
axes.text(0.78, 0.9, "by polling", color=RED, **bold)
axes.set_title("By callback: after milliseconds. By polling: up to 50 ms late")
show(
    fig,
    "how late the reports are: about a millisecond by callback, "
    "anything up to 50 ms by polling",
)

# %% [markdown]
# With polling, nothing happens until the next poll, so the average wait is half the sleep time. With a callback,
# there's no such wait. The *operating system* puts the executor's thread to sleep and wakes it as soon as a message
# arrives.
#
# What does this mean for the egg? The next animation uses each monitor's typical latency from this run. The fingers
# close at 100 mm/s and stop when the touch is reported. If they squeeze the shell by more than 2 mm, it breaks.

# %%
from workbook.pictures.egg import squeeze

squeeze(
    {
        "by callback": median(first.late(first.callback)),
        "by polling, every 50 ms": median(first.late(first.polling)),
    },
    "two eggs in slow motion: the fingers that hear of the touch by callback stop; "
    "those that poll crush the egg",
)

# %% [markdown]
# **Your turn.** Suppose that you have to poll. How long can the loop sleep if no egg may break, even in the worst case?
# Ignore the millisecond that the message takes to arrive.

# %% id="your-sleep"
from workbook.lesson import yours

longest_sleep_s = ...  # TODO: from 2 mm and 100 mm/s

yours(longest_sleep_s, 0.02, "In the worst case, a touch waits for the whole sleep.")

# %% [markdown] prediction="looking-more-often"
# ## Change it
#
# ### Experiment 1: poll more often
#
# Now make the loop sleep for 5 ms instead of 50 ms. How do its reports change?
#
# - **a** They come sooner, and no touch is missed.
#   when `times_as_late < 0.5 and reported >= sent * 2 / 3`
#   ✗ They do come sooner. But the touches in a bunch still overwrite each other before the next poll.
# - **b** They come sooner, but most touches are still missed.
#   when `times_as_late < 0.5 and reported < sent * 2 / 3`
#   ✓ The next poll comes sooner. But `monitor.last` still stores only one touch, and a bunch is usually over before the
#   next poll.
# - **c** They're just as late as before, but no touch is missed.
#   when `times_as_late >= 0.5`
#   ✗ A touch waits only until the next poll. With a shorter sleep, the next poll comes sooner.

# %%
predict("looking-more-often")

# %%
often = await match(poll_s=0.005)


def added_by_polling(of):
    """How much later than the callback polling typically reported in a run (ms)."""
    return median(of.late(of.polling)) - median(of.late(of.callback))


found = about(len(often.polling), between=(12, 79))
print(f"polling every 5 ms: {found} of {TOUCHES} touches reported")
print("typical delay:", typical(often, "polling", (1, 25)))
reveal(
    "looking-more-often",
    times_as_late=added_by_polling(often) / added_by_polling(first),
    reported=len(often.polling),
    sent=TOUCHES,
)

# %% [markdown]
# The loop polls ten times as often, but it still misses most touches, because touches in a bunch are less than a
# millisecond apart. As long as the monitor stores only one touch, no sleep is short enough.
#
# **Your turn.** Write a callback that doesn't miss any touches. The cell calls it three times, as the executor would.

# %% id="your-callback"
reported = []


def report(number):
    """What a monitor does with a touch."""
    reported.append(number)


def on_touch(message: Int32) -> None:
    ...  # TODO: report the number of this touch


for number in (1, 2, 3):
    on_touch(Int32(data=number))
yours(reported or ..., [1, 2, 3], "report(message.data)")

# %% [markdown] prediction="no-sleep"
# ### Experiment 2: no sleep at all
#
# Now the loop doesn't sleep: `while rclpy.ok(): monitor.look()`. As you saw in lesson 06, such a loop keeps a CPU core
# busy. But is it fast? Do the loop's reports come sooner or later than the callback's?
#
# - **a** Sooner: the loop polls a million times a second, but the callback's thread has to be woken first.
#   when `times_as_late < 0.8`
#   ✗ The loop holds Python's global interpreter lock (GIL), so the thread that receives messages has to wait.
# - **b** At about the same time.
#   when `0.8 <= times_as_late <= 1.2`
#   ✗ Both monitors need a thread that receives messages. In the polling monitor, that thread has to wait for a loop
#   that never sleeps.
# - **c** Later.
#   when `times_as_late > 1.2`
#   ✓ The loop holds the GIL, so the thread that receives messages has to wait, and each touch reaches the loop later.

# %%
predict("no-sleep")

# %%
from workbook.lesson import processor_seconds

restless = await match(touches=50, poll_s=0.0)
used = {
    "by callback": processor_seconds(callback_monitor, seconds=3.0, with_start=False),
    "polling, every 50 ms": processor_seconds(
        polling_monitor, seconds=3.0, with_start=False, poll_s=0.05
    ),
    "polling without a sleep": processor_seconds(
        polling_monitor, seconds=3.0, with_start=False, poll_s=0.0
    ),
}
by_polling = median(restless.late(restless.polling))
by_callback = median(restless.late(restless.callback))
reveal("no-sleep", times_as_late=by_polling / by_callback)

# %%
fig, axes = figure(6.4, 1.8)
bars = axes.barh(list(used), list(used.values()), color=[GREEN, BLUE, RED], height=0.6)
axes.bar_label(bars, [f"{seconds:.2f} s" for seconds in used.values()], padding=4)
axes.set_xlabel("processor time (s) in 3 s without a touch, start-up not counted")
axes.set_xlim(0, 3.6)
axes.set_title("Without a sleep, polling keeps a processor busy")
axes.grid(visible=False)
axes.invert_yaxis()
show(
    fig,
    "processor time: little by callback and with a sleep, "
    "nearly all of a processor without a sleep",
)

# %% id="restless"
print("without a sleep, polling is late by", typical(restless, "polling", (1, 60)))
print("the callback is late by", typical(restless, "callback", (0.1, 20)))
busy = about(used["polling without a sleep"], "s", between=(0.5, 6))
print("without a sleep, polling takes", busy, "of processor time in 3 s")
idle = about(used["by callback"], "s", between=(0, 0.5))
print("the callback takes", idle)

# %% [markdown]
# The loop never pauses, yet it's *slower* than the callback, whose thread sleeps until a message wakes it. The reason
# is Python's global interpreter lock (GIL). While the loop holds the GIL, the receiving thread can't run. So each time
# a message arrives, that thread starts a few milliseconds late.
#
# A busy CPU core also drains the battery, so the robot can't walk for as long.

# %% [markdown] prediction="a-queue-for-the-loop"
# ### Experiment 3: a queue for the loop
#
# Instead of overwriting `monitor.last`, the callback now adds each touch to a queue, and each poll empties that queue.
# The sleep is 50 ms again. How complete and how fast are the reports now?
#
# - **a** Complete, but late.
#   when `is_complete and late_ms >= 10`
#   ✓ The queue keeps every touch. But the loop reports them only at the next poll, up to 50 ms later.
# - **b** As good as the callback's.
#   when `is_complete and late_ms < 10`
#   ✗ No touch is missed now. But each one still waits in the queue until the loop wakes up.
# - **c** Fast, but incomplete.
#   when `not is_complete`
#   ✗ The queue has room for all the touches between two polls. But the reports aren't fast, because the loop still
#   sleeps.

# %%
predict("a-queue-for-the-loop")

# %%
patient = await match(poll_s=0.05, keep_all=True)
reported = sorted(number for number, _ in patient.polling)
is_complete = reported == list(range(1, TOUCHES + 1))
late_ms = median(patient.late(patient.polling))
print(f"{len(reported)} of {TOUCHES} touches reported")
print("typical delay:", typical(patient, "polling", (10, 100)))
reveal("a-queue-for-the-loop", is_complete=is_complete, late_ms=late_ms)

# %% [markdown]
# The loop no longer misses any touches. But every subscription already has a queue, so adding your own is redundant. As
# soon as a message enters the subscription's queue, an idle executor runs your callback. The loop only adds a delay.
#
# **When polling is right.** A controller that steers five times a second doesn't need every distance that the sensor
# publishes. It needs the *newest* distance, on *its own* schedule. So a callback stores the last value, and a **timer**
# reads it.
#
# For each message, first decide whether it's an event or a state. Every **event** matters: a touch, a button press, an
# alarm. With a **state**, such as a distance or a temperature, only the newest value matters. React to an event in the
# callback, but read a state with a timer.
#
# **Your turn.** Is each of these four messages an event or a state? Write `"event"` or `"state"`.

# %% id="your-kinds"
kinds = {
    "how warm the motor is": ...,  # TODO
    "a visitor rings the bell": ...,  # TODO
    "the battery's charge": ...,  # TODO
    "a parcel falls off the belt": ...,  # TODO
}
right = dict(zip(kinds, ("state", "event", "state", "event"), strict=True))

yours(kinds, right, "Would it matter if the robot missed one of two such messages?")

# %% [markdown]
# ## When it goes wrong
#
# **A loop that spins without waiting.** With `timeout_sec=0`, `spin_once` doesn't wait (lesson 06). The next program
# counts its loop's iterations, first with a timeout of 0 and then with 0.1 s:

# %%
from workbook.lesson import run_program

LOOP = """
import time

import rclpy
from rclpy.node import Node

rclpy.init()
node = Node("robot")
ticks = []
node.create_timer(0.1, lambda: ticks.append(time.monotonic()))
for timeout in (0.0, 0.1):
    ticks.clear()
    rounds, used = 0, time.process_time()
    while len(ticks) < 15:
        rclpy.spin_once(node, timeout_sec=timeout)
        rounds += 1
    print(timeout, rounds, time.process_time() - used)
rclpy.try_shutdown()
"""
outcome = run_program(LOOP, seconds=30)
lines = outcome.log.strip().splitlines()
greedy, calm = ([float(word) for word in line.split()] for line in lines)

# %% id="busy-loop"
USUAL = {0.0: ((200, 200_000), (0.02, 5)), 0.1: ((15, 150), (0, 0.3))}
for timeout, rounds, processor in (greedy, calm):
    usual_rounds, usual_s = USUAL[timeout]
    iterations = about(rounds, "iterations", between=usual_rounds)
    cost = about(processor, "s of processor time", between=usual_s)
    print(f"timeout_sec={timeout}: {iterations} for 15 ticks, {cost}")

# %% [markdown]
# `timeout_sec=0` is right if other code, such as a GUI's event loop, already does the waiting. In your own loop, use a
# longer timeout, such as 0.1 s. `spin_once` doesn't always wait that long: as soon as there's a callback to run, it
# runs the callback and returns. With `rclpy.spin(node)`, you don't need a loop at all.
#
# **A loop that sleeps forever.** ROS provides `rate.sleep()` for loops that run at a fixed rate, and many old examples
# use it. What does this program print?

# %% id="rate"
RATE = """
import rclpy
from rclpy.node import Node

rclpy.init()
node = Node("robot")
rate = node.create_rate(10)
print("the loop begins", flush=True)
for look in range(1, 11):
    rate.sleep()
    print("look", look, flush=True)
"""
outcome = run_program(RATE, silence=4)
print(outcome.log.strip().splitlines()[0])
print("looks:", outcome.log.count("look "))
print("ended by:", "the watchdog" if outcome.ended_by == "judge" else "itself")

# %% [markdown]
# The loop never got past its first sleep, but there was no error. `rate.sleep()` waits for one of the node's *timers*.
# But timers fire only while a thread spins the node, and the only thread was asleep. After four seconds without output,
# the watchdog (lesson 06) ended the program.
#
# `rate.sleep()` works if *another thread* spins the node. But a timer does the same job without a second thread:
# `node.create_timer(0.1, look)`.

# %% [markdown]
# ## From a worked example to your own
#
# **Worked example.** A walking robot's loop polls a stop button and a distance. Which one is an event, and which is a
# state?
#
# ```python
# while rclpy.ok():
#     rclpy.spin_once(node, timeout_sec=0)
#     if node.last_button != node.seen_button:      # the stop button was pressed
#         ...
#     steer(node.last_distance)                     # how far is the wall?
#     time.sleep(0.2)
# ```
#
# A button press is an event, so the callback handles it right away. The distance is a state, so the callback stores the
# value, and a timer reads it.

# %%
from std_msgs.msg import Float32, String


class Walker(Node):
    """Stops at once when told; steers five times a second by the newest distance."""

    def __init__(self) -> None:
        super().__init__("walker")
        self.stops: list[str] = []
        self.distance: float | None = None
        self.steered_by: list[float] = []
        self.create_subscription(String, "/walker/stop", self.on_stop, 10)
        self.create_subscription(Float32, "/walker/distance", self.on_distance, 10)
        self.create_timer(0.2, self.steer)

    def on_stop(self, message: String) -> None:
        self.stops.append(message.data)  # an event: act now, on each of them

    def on_distance(self, message: Float32) -> None:
        self.distance = message.data  # a state: keep the newest

    def steer(self) -> None:
        if self.distance is not None:  # unknown before the first message
            self.steered_by.append(self.distance)


walker = fresh(Walker)
world = fresh(Node, "world")
stopping = world.create_publisher(String, "/walker/stop", 10)
measuring = world.create_publisher(Float32, "/walker/distance", 10)
both = (stopping, measuring)
await run(world, until=lambda: all(one.get_subscription_count() == 1 for one in both))

for distance in (3.0, 2.5, 2.0):
    measuring.publish(Float32(data=distance))
for reason in ("button", "voice"):
    stopping.publish(String(data=reason))
await run(
    walker,
    seconds=10,
    until=lambda: len(walker.steered_by) >= 3 and walker.distance == 2.0,
)

print("stops:", walker.stops)
print("steers by:", walker.steered_by[-1])

# %% [markdown]
# A stored value doesn't show its age. If the sensor goes silent, this robot steers by the last distance forever. So
# store the time along with the value, and stop the robot when the value is too old (lesson 13).

# %% [markdown]
# **Fill in the blanks.** This reception robot polls a call button. If two visitors press the button during the same
# sleep, the robot greets only one of them. Replace the polling with a callback that greets each visitor. The two places
# that you need to change are marked TODO.


# %%
class ReceptionRobot(Node):
    """Greets each visitor who calls."""

    def __init__(self) -> None:
        super().__init__("reception_robot")
        self.last = ""
        self.greeted: list[str] = []
        self.create_subscription(String, "/reception/call", self.on_call, 10)

    def on_call(self, message: String) -> None:
        self.last = message.data
        # TODO: greet the visitor here, right away, with self.greet(...)

    def greet(self, visitor: str) -> None:
        self.greeted.append(visitor)


reception = fresh(ReceptionRobot)
calling = world.create_publisher(String, "/reception/call", 10)
await run(world, until=lambda: calling.get_subscription_count() == 1)
calling.publish(String(data="Ada"))
calling.publish(String(data="Grace"))

# TODO: replace these four lines with `await run(reception, seconds=1)`
for _ in range(3):
    await run(reception, seconds=0.3)
    if reception.last and reception.last not in reception.greeted:
        reception.greet(reception.last)

yours(reception.greeted, ["Ada", "Grace"], "Greet each visitor in on_call.")

# %% [markdown]
# **Your own.** In the [exercise](../exercises/11_polling_against_callbacks.ipynb), you get a monitor that polls.
# Rewrite it so that it reports every touch right away.

# %% [markdown]
# ## Check yourself
#
# **1. A loop sleeps for 0.2 s between polls. On average, how long does it take to notice an event?**
#
# <details><summary>a) About 0.1 s</summary>
#
# ✓ The delay is anything from 0 to 0.2 s, so the average is 0.1 s. This average doesn't include the events that the
# loop misses.
#
# </details>
# <details><summary>b) 0.2 s</summary>
#
# ✗ That's the worst case, when the event occurs just after a poll.
#
# </details>
# <details><summary>c) It depends on how often events occur</summary>
#
# ✗ The number of *missed* events depends on that. For the events that the loop does notice, the delay depends on the
# sleep time.
#
# </details>
#
# **2. A callback stores each message in `self.last`, which a loop polls every millisecond. Can the loop miss a message?**
#
# <details><summary>a) No, because ROS keeps messages until they're read</summary>
#
# ✗ ROS keeps a message only until your callback has run. After that, the message exists only in your attribute, until
# the next callback overwrites it.
#
# </details>
# <details><summary>b) No, because a millisecond is shorter than any pause between messages</summary>
#
# ✗ Messages that were published together arrive within a fraction of a millisecond of one another.
#
# </details>
# <details><summary>c) Yes, if two messages arrive during one sleep</summary>
#
# ✓ `self.last` stores only one message. In experiment 1, touches in a bunch were less than a millisecond apart.
#
# </details>
#
# **3. Why does a node that waits in `rclpy.spin` need almost no CPU time?**
#
# <details><summary>a) It polls only a few times a second</summary>
#
# ✗ If it did, its callbacks would run late. But in this lesson, the callback was only about a millisecond late.
#
# </details>
# <details><summary>b) It sleeps until the operating system wakes it for a message or a timer</summary>
#
# ✓ A thread that the operating system has put to sleep uses no CPU time.
#
# </details>
# <details><summary>c) rclpy runs in a separate process</summary>
#
# ✗ rclpy runs in your own process.
#
# </details>
#
# **4. For which of these should you store only the last value and read it with a timer?**
#
# <details><summary>a) The distance, for a controller that steers five times a second</summary>
#
# ✓ The distance is a state. The controller needs only the newest value, on its own schedule.
#
# </details>
# <details><summary>b) The stop button</summary>
#
# ✗ A press is an event. The robot must react right away, and to every press.
#
# </details>
# <details><summary>c) Parcels that have to be counted</summary>
#
# ✗ If two parcels fell between two reads, they'd be counted as one.
#
# </details>

# %% [markdown]
# ## Talk it through
#
# Read this prompt and write down your own answer. Then copy the prompt into an AI assistant, or discuss it with a
# colleague.
#
# ```text
# I'm programming a robot with ROS 2 Jazzy in Python (rclpy). My robot has a camera (30
# images per second), a bumper (it's rarely hit, but when it is, every moment counts), and
# a battery (one value every two seconds). A colleague wants one loop that checks all
# three every 20 ms, "because then I see the order in which things happen". How should I
# respond? Make sure that every rclpy function you use exists in Jazzy.
# ```
#
# <details><summary>What a good answer covers</summary>
#
# A bumper hit is an event. Polling would notice it up to 20 ms late and would count two hits within 20 ms as one. A
# callback is faster and misses neither. For most purposes, the camera image is a state. So use a queue depth of
# 1. Either handle the image in a callback, or store it and read it with a timer, as often as you need an image. The
# battery changes slowly, so 99 out of 100 polls would find nothing new.
#
# Your colleague wants to handle everything in one place and in order. A single-threaded executor also runs everything
# in one place, one callback after another. But neither design shows what happened first. The loop handles things in the
# order in which it checks them, and the executor handles timers before messages. To find the order of events, compare
# timestamps.
#
# A good answer also mentions CPU time. And it points out that one slow check delays all three (lesson 10).
#
# </details>
#
# <details><summary>What to check in the reply</summary>
#
# Watch for these two suggestions. We tested both with this course's rclpy, and both are wrong.
#
# - **`subscription.take()`:** That's C++ (rclcpp). In rclpy, a subscription has no public method for fetching a
#   message. Use the subscription's callback instead.
# - **`wait_for_message("/bumper", Bool, timeout=1.0)`:** That's ROS 1. In rclpy, write `wait_for_message(Bool, node,
#   "/bumper", time_to_wait=1.0)`. It returns two values: whether a message arrived, and the message.
#
# </details>

# %% [markdown]
# ## Take away
#
# - On average, a polling loop notices a message with a delay of half the sleep time. If the callback stores only the
#   last of several messages, the loop misses the others.
# - Polling more often shortens the delay, but it costs more CPU time and still misses messages. Polling without a sleep
#   is slow *and* expensive.
# - A callback runs once for each message. If the executor's thread is free, the callback runs as soon as the message
#   arrives. Waiting for messages costs almost no CPU time.
# - React to an event in the callback. Store a state, and read it with a timer.
# - A loop around `spin_once(timeout_sec=0)` keeps a CPU core busy for nothing. `rate.sleep()` never returns unless
#   another thread spins the node.
#
# **Before:** [10 · Slow callbacks](10_slow_callbacks.ipynb)
#
# **Next:** [12 · Services](12_services.ipynb): requests and responses.
#
# **More:** [About executors](https://docs.ros.org/en/jazzy/Concepts/Intermediate/About-Executors.html).
