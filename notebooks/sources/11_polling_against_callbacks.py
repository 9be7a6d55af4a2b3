# %% [markdown]
# # 11 · Polling against callbacks
#
# A robot hand that looks for a touch twenty times a second crushes the egg in between.
#
# - **Minutes:** 40
# - **You need:** lessons [05](05_timers.ipynb) and [10](10_slow_callbacks.ipynb)
# - **You will be able to:** tell polling from callbacks when you see it, measure what polling costs in time, in lost
#   messages and in processor time, and turn a loop that looks into callbacks
# - **Left out:** how much of a queue is right for which data (lesson 13), real-time systems

# %% [markdown]
# You wait for a parcel. You can go to the door every five minutes and look. Or you install a bell.
#
# Going to look is called **polling**. The bell is a **callback**: somebody else calls *you*. Here is a robot with both.
# The skin of its hand numbers each touch and reports it. Two monitors want to know.

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
# When people first hear of callbacks, many ask: why not simply a loop? Here are both monitors in short:
#
# ```python
# # A: a loop that looks                            # B: a callback
# def keep(message):                                def on_touch(message):
#     monitor.last = message.data                       report(message.data)
#
# Thread(target=spin, args=(monitor,)).start()      node.create_subscription(
# while rclpy.ok():                                     Int32, "/robot/touch", on_touch, 100)
#     if monitor.last != monitor.reported:          rclpy.spin(node)
#         monitor.reported = monitor.last
#         report(monitor.reported)
#     time.sleep(0.05)
# ```
#
# In A a second thread spins the node, so `keep` is called for each touch. The loop itself only looks.
#
# The hand closes around things: there are pauses, and then several touches in one moment. 120 touches in about five
# seconds. In that time A looks about 100 times. How many of the 120 touches does A report?
#
# - **a** Fewer than half.
#   when `reported < sent / 2`
#   ✓ The touches come in bunches, and of each bunch the loop sees only the last touch. The others are overwritten.
# - **b** About 100: one with each look.
#   when `sent / 2 <= reported < sent`
#   ✗ The loop does look about 100 times. But most looks fall into a pause and find nothing new.
# - **c** All 120, some of them a little late.
#   when `reported == sent`
#   ✗ `monitor.last` has room for one touch. Of several that come between two looks, only the last one is left.

# %%
from workbook.lesson import predict, reveal

predict("the-touches")

# %% [markdown]
# ## Run it
#
# A referee listens to all three. Each ROS message carries the moment at which it was sent; a callback with a second
# argument gets to see it. So the referee can tell how long each monitor took, however busy the referee itself is.

# %%
from rclpy.node import Node
from std_msgs.msg import Int32

from workbook.lesson import fresh, init, run

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
        referee, seconds=40, until=lambda: len(referee.touched) == len(set(referee.callback)) == touches
    )
    await run(referee, seconds=0.5)  # for those who come late
    stop()
    return referee


first = await match(poll_s=0.05)
print("touches:", len(first.touched))

# %% tags=["nbval-ignore-output"]
from statistics import median

for name in ("polling", "callback"):
    reports = getattr(first, name)
    print(f"{name:<9}{len(reports):>4} reported, typically {median(first.late(reports)):.1f} ms late")

# %% id="missed"
print("by callback, all in order:", [number for number, _ in first.callback] == list(range(1, TOUCHES + 1)))
print("by polling, fewer than half:", len(first.polling) < TOUCHES / 2)
reveal("the-touches", reported=len(first.polling), sent=TOUCHES)

# %% [markdown]
# ## Look inside
#
# Here are the first touches. Those that came in one moment stand above each other.

# %%
from workbook.pictures.figures import figure, show
from workbook.pictures.palette import BLUE, GREEN, GREY, RED

zero = first.touched[1]
touched_at = {number: (moment - zero) / 1000 for number, moment in first.touched.items()}
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
        marker, color = ("o", BLUE if row == 0 else GREEN) if number in numbers else ("x", RED)
        axes.plot(at, height, marker=marker, color=color, markersize=4)
axes.set(xlim=(-0.03, 1.5), ylim=(-2.6, 0.6), xlabel="s", yticks=[0, -1, -2], yticklabels=list(rows))
axes.grid(visible=False)
show(
    fig,
    "touches in bunches; by polling most of a bunch is missed (a cross), by callback each one is reported (a dot)",
)

# %% [markdown]
# A cross is a touch that nobody reported. The polling monitor keeps *the last* touch. When five come between two looks,
# the fifth is in `monitor.last`, and the other four were there only for a moment. It is not a matter of bad luck: of each
# bunch a look can find one.
#
# And what it finds, it finds late. The time from an event to the reaction is called **latency**. The next picture has
# both monitors on one axis, each step ten times the one before:

# %%
import numpy as np

fig, axes = figure(6.4, 2.6)
edges = np.logspace(-1, 2, 37)
axes.hist(first.late(first.callback), bins=edges, label="by callback", color=GREEN, alpha=0.85)
axes.hist(
    first.late(first.polling), bins=edges, label="by polling, every 50 ms", color=RED, alpha=0.6, hatch="//"
)
axes.axvline(50, linestyle="--", color=GREY)
axes.set(xscale="log", xlabel="late by (ms)", ylabel="reports", xlim=(0.1, 1000))
axes.set_xticks([0.1, 1, 10, 50, 100], ["0.1", "1", "10", "50", "100"])
axes.legend(loc="upper right")
show(fig, "how late the reports are: about a millisecond by callback, anything up to 50 ms by polling")

# %% id="late"
by_polling, by_callback = median(first.late(first.polling)), median(first.late(first.callback))
print("polling is typically late by 10 ms or more:", by_polling >= 10)
print("callbacks are at least four times as quick:", by_callback < by_polling / 4)

# %% [markdown]
# With polling, a touch waits for the next look: sometimes 50 ms, sometimes nothing, on average half the sleep. With a
# callback it waits for nobody. The executor sleeps *in the operating system*, which wakes it when a message arrives.
# That is the bell.

# %% [markdown] prediction="looking-more-often"
# ## Change it
#
# ### Experiment 1: look more often
#
# The obvious remedy: sleep for 5 ms in place of 50. What follows?
#
# - **a** Quick now, and nothing is missed any more.
#   when `times_as_late < 0.5 and reported >= sent * 2 / 3`
#   ✗ It is quicker. But the touches of a bunch still overwrite each other before the next look.
# - **b** Quick now, but most touches are missed all the same.
#   when `times_as_late < 0.5 and reported < sent * 2 / 3`
#   ✓ Less time passes until the next look. But there is still room for one touch only, and a bunch is over within a
#   moment.
# - **c** As slow as before, but nothing is missed.
#   when `times_as_late >= 0.5`
#   ✗ A touch waits until the loop looks again. With a shorter sleep that is sooner.

# %%
predict("looking-more-often")

# %%
often = await match(poll_s=0.005)


def added_by_polling(of):
    """How much later than the callback polling typically reported, in the same run (ms)."""
    return median(of.late(of.polling)) - median(of.late(of.callback))


print("polling adds less than half of what it added before:", added_by_polling(often) < added_by_polling(first) / 2)
print("fewer than two thirds seen:", len(often.polling) < TOUCHES * 2 / 3)
reveal(
    "looking-more-often",
    times_as_late=added_by_polling(often) / added_by_polling(first),
    reported=len(often.polling),
    sent=TOUCHES,
)

# %% [markdown]
# Ten times as many looks, and hardly any touch more. The five touches of a bunch lie less than a millisecond apart. No
# sleep is short enough for that, as long as there is room for one touch only.

# %% [markdown] prediction="no-sleep"
# ### Experiment 2: do not sleep at all
#
# Then leave the sleep away! `while rclpy.ok(): monitor.look()`, as fast as the processor can. Compared with the callback,
# this is
#
# - **a** quicker, since it looks a million times a second, and that costs a whole processor;
#   when `not is_later and times_the_processor_time > 10`
#   ✗ It does cost a whole processor. But the loop holds Python's lock, the GIL, and the thread that receives has to
#   wait for it.
# - **b** the same: a loop that finds nothing does no work.
#   when `times_the_processor_time <= 10`
#   ✗ To look is work as well, and this loop looks without a pause. Only a thread that sleeps costs nothing.
# - **c** slower, *and* it costs a whole processor;
#   when `is_later and times_the_processor_time > 10`
#   ✓ The loop never rests, and keeps Python's lock, the GIL, from the thread that receives. So the touch comes in
#   later.

# %%
predict("no-sleep")

# %%
from workbook.lesson import processor_seconds

restless = await match(touches=50, poll_s=0.0)
used = {
    "by callback": processor_seconds(callback_monitor, seconds=3.0, with_start=False),
    "polling, every 50 ms": processor_seconds(polling_monitor, seconds=3.0, with_start=False, poll_s=0.05),
    "polling without a sleep": processor_seconds(polling_monitor, seconds=3.0, with_start=False, poll_s=0.0),
}

# %%
fig, axes = figure(6.4, 1.8)
bars = axes.barh(list(used), list(used.values()), color=[GREEN, BLUE, RED], height=0.6)
axes.bar_label(bars, [f"{seconds:.2f} s" for seconds in used.values()], padding=4)
axes.set(xlabel="processor time (s) in 3 s without a touch", xlim=(0, 3.6))
axes.grid(visible=False)
axes.invert_yaxis()
show(fig, "processor time: little by callback and with a sleep, nearly all of a processor without a sleep")

# %% id="restless"
slower = median(restless.late(restless.polling)) > median(restless.late(restless.callback))
print("without a sleep, polling is later than the callback:", slower)
print(
    "without a sleep, it needs at least ten times the processor time:",
    used["polling without a sleep"] > 10 * used["by callback"],
)
reveal(
    "no-sleep",
    is_later=slower,
    times_the_processor_time=used["polling without a sleep"] / used["by callback"],
)

# %% [markdown]
# It looks without a pause, and is *slower* than the callback, which sleeps until it is woken. Why? The loop holds
# Python's lock, the GIL, and the thread that receives has to beg for a turn: a few milliseconds each time. Whoever
# asks "is it there yet?" all the time keeps the postman from the door.
#
# And the processor that it burns is missing elsewhere. On a battery robot it is missing as minutes of walking.

# %% [markdown] prediction="keep-them-all"
# ### Experiment 3: keep them all
#
# A better remedy: not `monitor.last = …`, but a queue, which a look empties. We go back to a sleep of 50 ms. Now polling
# is
#
# - **a** complete, but late;
#   when `is_complete and late_ms >= 10`
#   ✓ The queue keeps every touch. The loop finds them with its next look, up to 50 ms later.
# - **b** as good as the callback;
#   when `is_complete and late_ms < 10`
#   ✗ Nothing is missed any more. But each touch still waits in the queue until the loop wakes up.
# - **c** quick, but not complete.
#   when `not is_complete`
#   ✗ The queue has room for all touches that come between two looks. The delay comes from the sleep.

# %%
predict("keep-them-all")

# %%
patient = await match(poll_s=0.05, keep_all=True)
print("all reported:", sorted(number for number, _ in patient.polling) == list(range(1, TOUCHES + 1)))
print("typically late by 10 ms or more:", median(patient.late(patient.polling)) >= 10)
reveal(
    "keep-them-all",
    is_complete=sorted(number for number, _ in patient.polling) == list(range(1, TOUCHES + 1)),
    late_ms=median(patient.late(patient.polling)),
)

# %% [markdown]
# Nothing is lost any more. But now you have built by hand what the subscription has anyway: it *is* a queue, and the
# executor calls you as soon as something is in it. The loop adds nothing but the delay.
#
# **When looking is right.** There is an honest use of it. A controller that steers five times a second does not want
# to know of every distance that the sensor has sent. It wants the *newest*, at *its own* moments. So it keeps the
# last value in a callback, and a
# **timer** looks at it. Then "only the last one" is a feature.
#
# Ask yourself: is each message an **event** (a touch, a button, an alarm), or is it a **state** of which only the newest
# counts (a distance, a temperature)? Events want a callback that acts. States may be looked at.

# %% [markdown]
# ## When it goes wrong
#
# **The loop that spins.** Somebody has read that a node must be spun, and that `timeout_sec=0` does not wait. So the loop
# spins without waiting. This runs as a program of its own and counts, once with 0 and once with 0.1:

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
greedy, calm = ([float(word) for word in line.split()] for line in outcome.log.strip().splitlines())

# %% tags=["nbval-ignore-output"]
for timeout, rounds, processor in (greedy, calm):
    print(f"timeout_sec={timeout}: {rounds:.0f} rounds for 15 ticks, {processor:.2f} s of processor time")

# %% id="busy-loop"
print("with 0, more than ten times as many rounds for the same 15 ticks:", greedy[1] > 10 * calm[1])
print("and they cost more processor time:", greedy[2] > calm[2])

# %% [markdown]
# No error, the ticks come, and the fan begins to howl. `timeout_sec=0` is right where something else waits already, as
# the event loop of a window does. In a loop of its own give it a time, 0.1 for example: it returns earlier if there is
# something to do. Better still, `rclpy.spin(node)`, and no loop at all.
#
# **The loop that sleeps for good.** ROS has a sleep of its own, for loops with a rate. It is in many old examples. What
# does this program print?

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
print("ended by:", "the watchdog" if outcome.ended_by == "bench" else "itself")

# %% [markdown]
# Not one look, and no error. `rate.sleep()` waits for a *timer* of the node. Timers tick when somebody spins, and the only
# one who could spin is asleep. The watchdog had to end it.
#
# A rate works if *another thread* spins the node. But then you have two threads, a loop and a lock to think of, to do
# what one line does: `node.create_timer(0.1, look)`.

# %% [markdown]
# ## From a worked example to your own
#
# **Worked.** A walking robot has a loop that looks at two things. Which is an event, and which is a state?
#
# ```python
# while rclpy.ok():
#     rclpy.spin_once(node, timeout_sec=0)
#     if node.last_button != node.seen_button:      # somebody has pressed the stop button
#         ...
#     steer(node.last_distance)                     # how far is the wall?
#     time.sleep(0.2)
# ```
#
# The button is an event: a callback that acts. The distance is a state: a callback that keeps, and a timer that looks.

# %%
from std_msgs.msg import Float32, String


class Walker(Node):
    """Stops at once when told, and steers five times a second by the newest distance."""

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
        if self.distance is not None:  # before the first message nobody knows where the wall is
            self.steered_by.append(self.distance)


walker = fresh(Walker)
world = fresh(Node, "world")
stopping = world.create_publisher(String, "/walker/stop", 10)
measuring = world.create_publisher(Float32, "/walker/distance", 10)
await run(world, until=lambda: stopping.get_subscription_count() == measuring.get_subscription_count() == 1)

for distance in (3.0, 2.5, 2.0):
    measuring.publish(Float32(data=distance))
for reason in ("button", "voice"):
    stopping.publish(String(data=reason))
await run(walker, seconds=10, until=lambda: len(walker.steered_by) >= 3 and walker.distance == 2.0)

print("stops:", walker.stops)
print("steers by:", walker.steered_by[-1])

# %% [markdown]
# A value that is kept says nothing of its age. If the sensor dies, this robot steers by its last word for ever. So note
# the time with the value, and stop when it is too old (lesson 13).

# %% [markdown]
# **Faded.** This door robot polls a bell. Two visitors ring within one sleep, and one of them is left standing. Turn it
# into a callback that acts. There are two places with a TODO.


# %%
class DoorRobot(Node):
    """Greets whoever rings."""

    def __init__(self) -> None:
        super().__init__("door_robot")
        self.last = ""
        self.greeted: list[str] = []
        self.create_subscription(String, "/door/bell", self.on_bell, 10)

    def on_bell(self, message: String) -> None:
        self.last = message.data
        # TODO: greet the visitor here, at once, with self.greet(...)

    def greet(self, visitor: str) -> None:
        self.greeted.append(visitor)


door = fresh(DoorRobot)
bell = world.create_publisher(String, "/door/bell", 10)
await run(world, until=lambda: bell.get_subscription_count() == 1)
bell.publish(String(data="Ada"))
bell.publish(String(data="Grace"))

for _ in range(3):  # TODO: away with these four lines, `await run(door, seconds=1)` is enough
    await run(door, seconds=0.3)
    if door.last and door.last not in door.greeted:
        door.greet(door.last)

print("greeted:", door.greeted)
print("nobody is left standing" if door.greeted == ["Ada", "Grace"] else "somebody is still at the door")

# %% [markdown]
# **Your own.** In the [exercise](../exercises/11_polling_against_callbacks.ipynb) you get a monitor that polls, and turn it
# into one that misses nothing and is quick.

# %% [markdown]
# ## Check yourself
#
# **1. A loop sleeps for 0.2 s between two looks. How late does it notice an event, on average?**
#
# <details><summary>a) About 0.1 s</summary>
#
# ✓ Anything from nothing to 0.2 s, so half of it on average. If it notices it at all.
#
# </details>
# <details><summary>b) 0.2 s</summary>
#
# ✗ That is the worst case: the event came just after a look.
#
# </details>
# <details><summary>c) It depends on how often events come</summary>
#
# ✗ How *many* it misses depends on that. How late the others are depends on the sleep.
#
# </details>
#
# **2. A callback stores `self.last`, a loop looks at it every millisecond. Can it miss a message?**
#
# <details><summary>a) No, ROS keeps messages until they are read</summary>
#
# ✗ Up to the moment at which your callback has run. Then the message is yours, and you overwrote it.
#
# </details>
# <details><summary>b) No, a millisecond is shorter than any pause between messages</summary>
#
# ✗ Messages that were published together arrive within a fraction of that.
#
# </details>
# <details><summary>c) Yes, if two come within one sleep</summary>
#
# ✓ Room for one is room for one. You saw it with 5 ms.
#
# </details>
#
# **3. Why does a node that waits in `rclpy.spin` need almost no processor time?**
#
# <details><summary>a) It looks only a few times a second</summary>
#
# ✗ Then it would be late, as polling is. It was late by a millisecond.
#
# </details>
# <details><summary>b) It sleeps until the operating system wakes it for a message or a timer</summary>
#
# ✓ That is the bell.
#
# </details>
# <details><summary>c) Because rclpy runs in a process of its own</summary>
#
# ✗ It runs in yours. What uses no processor is waiting.
#
# </details>
#
# **4. Where is it right to keep only the last value and look at it with a timer?**
#
# <details><summary>a) The distance for a controller that steers five times a second</summary>
#
# ✓ A state: the newest is all it needs, at its own pace.
#
# </details>
# <details><summary>b) The stop button</summary>
#
# ✗ An event. It must act at once, and each time.
#
# </details>
# <details><summary>c) Parcels that shall be counted</summary>
#
# ✗ Two between two looks would count as one.
#
# </details>

# %% [markdown]
# ## Talk it through
#
# Discuss this with a colleague or an AI assistant:
#
# > My robot has a camera (30 pictures a second), a bumper (rarely, but then at once), and a battery (one value in two
# > seconds). A colleague wants one loop that checks all three every 20 ms, "because then I see the order in which things
# > happen". What would you answer?
#
# <details><summary>What a good answer contains</summary>
#
# The bumper is an event: up to 20 ms late by looking, and two bumps within 20 ms are one. A callback is quicker and
# complete. The camera is a state for most purposes: only the newest picture counts, so a queue of depth 1 and a
# callback, or a timer at the pace of what uses it. The battery is slow, and looking fifty times a second finds
# nothing new in 99 of 100 looks. The wish behind the loop is fair: one place, one order. An executor with one thread
# gives you the one place as well: callbacks run one after the other, never at once, and no locks are needed. Neither
# of the two gives you the order in which things happened: of what waits, the loop takes what it checks first, and the
# executor takes timers before messages. Whoever needs the order compares time stamps. Good answers mention what the
# loop does to the processor, and what happens when checking one of the three takes long (lesson 10): the loop stands
# still for all three, just as callbacks in one thread do.
#
# </details>

# %% [markdown]
# ## Take away
#
# - Polling finds things late, by half the sleep on average, and finds one where several came.
# - Looking more often makes it quicker and dearer, not complete. Without a sleep it is slow *and* dear.
# - A callback is called as soon as a message is there, once for each, and waiting for it costs nothing.
# - Events want a callback that acts. States may be kept, and looked at with a timer.
# - `spin_once(timeout_sec=0)` in a loop burns a processor; `rate.sleep()` without somebody who spins never returns.
#
# **Before:** [10 · Slow callbacks](10_slow_callbacks.ipynb)
#
# **Next:** [12 · Services](12_services.ipynb): a question, and an answer to it.
#
# **More:** [About executors](https://docs.ros.org/en/jazzy/Concepts/Intermediate/About-Executors.html), who wait so that
# you need not look.
