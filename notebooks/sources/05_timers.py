# %% [markdown]
# # 05 · Timers
#
# A robot sends its heartbeat, corrects its balance, and reports its battery level, each at a fixed rate. How does a
# program do that? In rclpy, a timer calls a function again and again. This lesson shows how to set its rate, and what
# happens when the function takes too long.
#
# - **Minutes:** 50
# - **You need:** lesson 00. You should also know that `publish` sends a message to a topic
# - **You will be able to:**
#   - make a node repeat its work at a fixed rate
#   - convert a frequency to a period
#   - run callbacks at several rates in one node
#   - predict how a slow callback affects a node's timers
# - **Not covered:** how `spin` works (lesson 06), and how to do slow work properly (lesson 10)

# %% [markdown]
# Watch the robot. Both arms are meant to make the same movement. A timer that ticks every 0.05 s moves the arm marked
# **L**. Another timer, which ticks once a second, moves the arm marked **R**.

# %%
from lesson_nodes import two_arms
from workbook.lesson import start, stop, watch_robot

print("started", start(two_arms, left_period_s=0.05, right_period_s=1.0))
await watch_robot(seconds=8, ease=0.0)
stop()

# %% [markdown]
# Both timers belong to the same node. Run the next cell and move its slider, which sets the period of the timer that
# moves **R**. Each time you move the slider, the node restarts. How short does the period have to be before you no
# longer see a difference between the arms?
#
# [the same without helpers: start, init, fresh, run, record]

# %%
from workbook.lesson import knob

await knob(
    two_arms, "right_period_s", 1.0, between=(0.05, 1.5), seconds=8, left_period_s=0.05
)

# %% [markdown] prediction="loop-and-timer"
# ## Predict
#
# A robot reads its tilt sensor ten times a second. Each reading takes 10 ms. Here are two ways to take fifty readings:
#
# ```python
# # A: a loop that sleeps
# for _ in range(50):
#     time.sleep(0.1)
#     read_tilt()
# ```
#
# ```python
# # B: a timer
# node.create_timer(0.1, read_tilt)
# rclpy.spin(node)
# ```
#
# `create_timer(0.1, read_tilt)` creates a timer with a period of 0.1 s. While `spin` runs, it calls `read_tilt` each
# time the timer is due.
#
# Fifty periods of 0.1 s add up to 5.0 s. How long does each program take to collect its fifty readings?
#
# - **a** Both take 5.0 s, because the period is 0.1 s in both.
#   when `loop_s < 5.5 and timer_s < 5.5`
#   ✗ They would if reading took no time. But the loop sleeps for 0.1 s after each reading, so each iteration takes
#   0.11 s.
# - **b** The loop takes at least 5.5 s, and the timer takes about 5.0 s.
#   when `loop_s >= 5.5 and timer_s < loop_s`
#   ✓ The loop adds 10 ms of reading to each sleep: 50 times 0.11 s. The timer's period keeps running during the
#   reading, so the reading adds no time.
# - **c** Both take at least 5.5 s, because reading takes time in both.
#   when `loop_s >= 5.5 and timer_s >= loop_s`
#   ✗ Reading takes 10 ms in both. But after a reading, the timer waits only for the rest of its period, which is 90 ms.
# - **d** The loop takes 5.0 s, and the timer takes longer, because ROS has more to do.
#   when `loop_s < 5.5 and timer_s >= 5.5`
#   ✗ ROS does have more to do for each tick. But that takes well under a millisecond, and the period keeps running
#   during that time.

# %%
from workbook.lesson import predict, reveal

predict("loop-and-timer")

# %% [markdown]
# ## Run it
#
# We start with the loop. `time.sleep(0.010)` stands in for the sensor, which takes 10 ms. The loop records the time of
# each reading.

# %%
import time

PERIOD_S = 0.1
ROUNDS = 50


def read_tilt() -> float:
    """Read the tilt of the body (rad). The sensor takes 10 ms to answer."""
    time.sleep(0.010)
    return 0.02


began = time.monotonic()
loop_moments = []
for _ in range(ROUNDS):
    time.sleep(PERIOD_S)
    loop_moments.append(time.monotonic() - began)
    read_tilt()
loop_s = time.monotonic() - began

print(len(loop_moments), "readings by the loop")

# %% [markdown]
# Now we use a timer, with the method `on_tick` as its callback. `run` spins the node, as `rclpy.spin` would, but it
# returns after fifty ticks.

# %%
from rclpy.node import Node

from workbook.lesson import about, fresh, init, run

init()


class TiltReader(Node):
    """Reads the tilt sensor on every tick of a timer."""

    def __init__(self) -> None:
        super().__init__("tilt_reader")
        self.began = time.monotonic()
        self.moments: list[float] = []
        self.create_timer(PERIOD_S, self.on_tick)

    def on_tick(self) -> None:
        self.moments.append(time.monotonic() - self.began)
        read_tilt()


reader = fresh(TiltReader)
await run(reader, seconds=20, until=lambda: len(reader.moments) == ROUNDS)
timer_s = time.monotonic() - reader.began

print(len(reader.moments), "readings by the timer")

# %% id="loop-and-timer"
print("the loop took ", about(loop_s, "s", between=(5.5, 7.5), digits=3))
print("the timer took", about(timer_s, "s", between=(4.9, 5.4), digits=3))
reveal("loop-and-timer", loop_s=loop_s, timer_s=timer_s)

# %% [markdown]
# ## Look inside
#
# The figure shows the first readings. The small marks above and below each line show the schedule: one reading every
# 0.1 s.

# %%
from workbook.pictures.figures import figure, show
from workbook.pictures.timeline import strip

first = {"loop": loop_moments[:14], "timer": reader.moments[:14]}
picture = strip(
    first,
    periods={"loop": PERIOD_S, "timer": PERIOD_S},
    end=1.6,
    noun="readings",
    title="The loop falls behind its schedule; the timer keeps it",
)
show(
    picture,
    "the first readings of loop and timer: the loop falls behind the plan, the timer "
    "stays on it",
)

# %% [markdown]
# The loop always sleeps for the full 0.1 s, and the work comes on top of that. So each iteration takes 0.1 s **plus**
# the time for the work. Every iteration starts a little later than it should, and these delays add up. This is called
# **drift**.
#
# The timer follows a schedule: counted from its creation, its ticks are due at 0.1 s, 0.2 s, 0.3 s, and so on. When the
# work is done, the timer waits only for the rest of the current period. So one late tick doesn't delay the next one.
#
# **Your turn.** A loop can keep a schedule, too. It must take reading number `n` exactly `n` periods after the start.
# If `passed_s` seconds have already passed since the start, how long must the loop sleep before that reading?

# %% id="your-sleep"
from workbook.lesson import yours


def sleep_s(n: int, passed_s: float) -> float:
    return ...  # TODO: from n, PERIOD_S, and passed_s


yours(
    (sleep_s(3, 0.21), sleep_s(50, 4.96)),
    (0.09, 0.04),
    "Reading n is due n * PERIOD_S after the start.",
)

# %% [markdown]
# The next figure shows how late each reading was, for the loop and for the timer.

# %%
from itertools import pairwise


def lateness(moments):
    """How late each reading is (ms), if the first one was on time."""
    return [
        1000 * (moment - moments[0] - PERIOD_S * n) for n, moment in enumerate(moments)
    ]


fig, axes = figure(6.4, 2.6)
axes.plot(lateness(loop_moments), color="#b06a00")
axes.plot(lateness(reader.moments), linestyle="--", color="#2f78d0")
axes.text(ROUNDS, lateness(loop_moments)[-1], "loop", va="center")
axes.text(ROUNDS, lateness(reader.moments)[-1], "timer", va="center")
axes.set(
    xlabel="reading",
    ylabel="delay (ms)",
    xlim=(-1, 57),
    title="The loop's delay grows with every reading; the timer's doesn't",
)
show(
    fig,
    "the lateness of the loop grows with every reading; that of the timer does not "
    "grow",
)
loop_ms, timer_ms = lateness(loop_moments)[-1], lateness(reader.moments)[-1]
print("last reading of the loop: ", about(loop_ms, "ms late", between=(400, 2000)))
print("last reading of the timer:", about(timer_ms, "ms late", between=(-200, 200)))

# %% [markdown]
# No timer is perfect. The operating system also runs other programs, so a tick can be a little late, and then the next
# interval is a little shorter. This is called **jitter**. Unlike drift, it doesn't add up.

# %%
from workbook.pictures.timeline import histogram

intervals_ms = [1000 * (b - a) for a, b in pairwise(reader.moments)]
mean_ms = sum(intervals_ms) / len(intervals_ms)
show(
    histogram(
        intervals_ms,
        target=1000 * PERIOD_S,
        label="time between two ticks",
        title="Jitter: the intervals scatter around 100 ms",
    ),
    "a histogram of the times between two ticks, around the 100 ms that were asked for",
)
shortest_ms, longest_ms = min(intervals_ms), max(intervals_ms)
print("shortest:", about(shortest_ms, "ms", between=(0, 100), digits=3))
print("mean:    ", about(mean_ms, "ms", between=(95, 105), digits=3))
print("longest: ", about(longest_ms, "ms", between=(100, 300), digits=3))

# %% [markdown]
# ### A myth, tested
#
# You'll sometimes read that you must store a timer in an attribute, as in `self.timer = self.create_timer(...)`, or the
# garbage collector will delete it. The node above stored nothing, yet its timer worked. To be sure, the next cell
# creates another such node, and then runs the garbage collector explicitly.

# %% id="nothing-kept"
import gc


class Forgetful(Node):
    """Makes a timer and does not keep it."""

    def __init__(self) -> None:
        super().__init__("forgetful")
        self.ticks = 0
        self.create_timer(0.2, self.on_tick)

    def on_tick(self) -> None:
        self.ticks += 1


forgetful = fresh(Forgetful)
gc.collect()
await run(forgetful, seconds=5, until=lambda: forgetful.ticks == 5)
print("ticks after the garbage collection:", forgetful.ticks)

# %% [markdown]
# The timer still ticks, because in rclpy, the node keeps a reference to each of its timers. In C++, you really do have to
# store the timer. An attribute is still useful in Python if you want to stop the timer later with `self.timer.cancel()`.

# %% [markdown]
# ## Change it
#
# At one tick per second, counting sixty ticks takes a minute. **Simulated time** makes this faster: a ROS node can read
# the time from the topic `/clock` instead of the computer's clock. `record` starts a program in this mode and publishes
# a time on `/clock` that runs ten to twenty times as fast as the computer's clock. So a minute passes for the node
# within a few seconds. In this course, we call this simulated time **robot time**.

# %% [markdown] prediction="half-a-hertz"
# ### Experiment 1: half a hertz
#
# A robot should beep at 0.5 Hz, which is 30 times a minute. A programmer writes `create_timer(0.5, self.beep)`. How
# many beeps do we count in one minute of robot time?
#
# - **a** 30, as intended
#   when `beeps < 45`
#   ✗ 30 beeps a minute would be one every 2 s. But `create_timer` interprets 0.5 as seconds, not as hertz.
# - **b** 60
#   when `45 <= beeps < 90`
#   ✗ 60 beeps a minute would be one every 1.0 s. But the period is 0.5 s.
# - **c** 120
#   when `beeps >= 90`
#   ✓ The timer beeps every 0.5 s, which is twice a second. So its frequency is 2 Hz, four times the intended one.

# %%
predict("half-a-hertz")

# %%
from lesson_nodes import blink_and_beep
from workbook.lesson import arrivals, record

BEEP, BLINK = "/robot/beep", "/robot/blink"
period_s = 0.5  # turn this knob

minute = record(blink_and_beep, {BEEP: period_s}, seconds=60, beep_period_s=period_s)
print(f"a period of {period_s} s: {len(arrivals(minute, BEEP))} beeps in a minute")
reveal("half-a-hertz", beeps=len(arrivals(minute, BEEP)))

# %% [markdown]
# `create_timer` takes a **period**, the number of seconds from one tick to the next. A value in hertz is a
# **frequency**, the number of ticks per second. Each is 1 divided by the other: 100 Hz corresponds to a period of 0.01
# s. The lower the frequency, the longer the period.
#
# **Your turn.** Write the period for 0.5 Hz. The cell then counts the beeps in another minute.

# %% id="your-period"
period_s = ...  # TODO: seconds from one beep to the next

beeps = ...
if period_s is not ...:
    minute = record(
        blink_and_beep, {BEEP: period_s}, seconds=60, beep_period_s=period_s
    )
    beeps = len(arrivals(minute, BEEP))
yours(beeps, 30, "Divide 1 by the frequency.")

# %% [markdown] prediction="two-timers-due"
# ### Experiment 2: two timers in one node
#
# Now the node blinks at 1 Hz and beeps at 0.5 Hz. Every 2 s, both timers are due at the same moment. The node has one
# thread, so it can run only one callback at a time. How many blinks and beeps do we count in a minute?
#
# - **a** 60 blinks and 30 beeps: one callback waits for the other, but both run.
#   when `blinks > 50 and 20 < beeps < 40`
#   ✓ A timer that is due stays due until its callback has run. So the second callback runs right after the first one.
# - **b** 30 blinks and 30 beeps: when both are due, the blink is skipped.
#   when `20 < blinks < 40 and 20 < beeps < 40`
#   ✗ A short wait doesn't make a timer skip a tick. The executor runs the second callback as soon as the first one
#   returns.
# - **c** 60 blinks and no beeps: the beep is never due alone, so it's always skipped.
#   when `blinks > 50 and beeps < 10`
#   ✗ The timer that was created first doesn't displace the other one. The executor runs both callbacks, one after the
#   other.
# - **d** 45 of each, because the two timers take turns.
#   when `40 <= blinks <= 50 and 40 <= beeps <= 50`
#   ✗ The callbacks take turns only when both are due. Each timer's own period determines how often it's due.

# %%
predict("two-timers-due")

# %%
both = record(
    blink_and_beep,
    {BLINK: 1.0, BEEP: 2.0},
    seconds=60,
    blink_period_s=1.0,
    beep_period_s=2.0,
)
print(len(arrivals(both, BLINK)), "blinks and", len(arrivals(both, BEEP)), "beeps")
reveal(
    "two-timers-due",
    blinks=len(arrivals(both, BLINK)),
    beeps=len(arrivals(both, BEEP)),
)

# %%
ten_seconds = {
    name: [t for t in arrivals(both, name) if t < 10.5] for name in (BLINK, BEEP)
}
for name, moments in ten_seconds.items():
    print(name, "at", [round(moment) for moment in moments], "s")
show(
    strip(
        ten_seconds,
        periods={BLINK: 1.0, BEEP: 2.0},
        end=10.5,
        title="Both timers keep their rates, although both are due every 2 s",
    ),
    "ten seconds of robot time: a blink every second, and a beep with every second "
    "blink",
)

# %% [markdown]
# Between two ticks, a timer doesn't block the thread. It only determines when its callback is due. The *executor*,
# which runs a node's callbacks, sleeps until the next timer is due, calls that timer's callback, and sleeps again. When
# two timers are due at the same time, one callback runs after the other. As long as both callbacks are short, you don't
# notice the delay.

# %% [markdown] prediction="the-long-beep"
# ### Experiment 3: a slow callback
#
# What if one callback is slow? The node blinks every 0.2 s. Every 2 s, it also beeps, which takes 1.1 s. During a beep,
# five blinks are due. What happens to them?
#
# - **a** They all come in a burst after the beep.
#   when `blinks_per_beep >= 9 and shortest_gap_s < 0.02`
#   ✗ A timer doesn't count the ticks that it missed, so it has nothing to catch up on.
# - **b** They come on schedule, because a timer can interrupt the beep.
#   when `blinks_per_beep >= 9 and shortest_gap_s >= 0.02 and longest_gap_s < 0.5`
#   ✗ The node has only one thread. There, the executor runs one callback after the other, and it can't interrupt a
#   running callback.
# - **c** They all come, but every blink from then on is late.
#   when `blinks_per_beep >= 9 and shortest_gap_s >= 0.02 and longest_gap_s >= 0.5`
#   ✗ A loop that sleeps would behave like this. A timer returns to its schedule.
# - **d** One is late, and the others are dropped.
#   when `blinks_per_beep < 9`
#   ✓ After the beep, the blink timer is due, so it ticks once. The timer drops the ticks that it missed.

# %%
predict("the-long-beep")

# %% [markdown]
# This recording uses the wall clock and takes eight seconds, because the beep takes real time.

# %%
from statistics import median

long_beep = {"blink_period_s": 0.2, "beep_period_s": 2.0, "beep_takes_s": 1.1}
slow = record(
    blink_and_beep, {BLINK: 0.2, BEEP: 2.0}, seconds=8.5, clock="wall", **long_beep
)

blinks, beeps = arrivals(slow, BLINK), arrivals(slow, BEEP)
came = [sum(a - 0.1 < t < b - 0.1 for t in blinks) for a, b in pairwise(beeps[:4])]
gaps = [b - a for a, b in pairwise(blinks)]
reveal(
    "the-long-beep",
    blinks_per_beep=median(came),
    shortest_gap_s=min(gaps),
    longest_gap_s=max(gaps),
)

# %% id="no-burst"
seen = {BLINK: [t for t in blinks if t < 7.5], BEEP: [t for t in beeps if t < 7.5]}
show(
    strip(
        seen,
        periods={BLINK: 0.2, BEEP: 2.0},
        end=7.5,
        title="After each beep, the blinks stop for 1.1 s, and no burst follows",
    ),
    "blinks every 0.2 s; after each beep a red frame, 1.1 s long, without a blink",
)
closest = about(1000 * min(gaps), "ms", between=(20, 200))
print("blinks due from one beep to the next:", round(2.0 / 0.2))
print("blinks that came, as a rule:         ", median(came))
print("shortest time between two blinks:    ", closest)

# %% [markdown]
# A red frame (✗) marks each gap between blinks that's longer than one and a half periods. The small marks show the
# schedule, and a mark without a blink is a missed tick.
#
# The next diagram shows how the executor handles the two timers. (Lesson 04 explains how to read it.) Unlike a
# subscription, a timer has no queue, so at most one of its ticks can wait.

# %% id="machine"
from workbook.lesson import record_machine, show_machine

show_machine(
    record_machine(blink_and_beep, seconds=3.8, **long_beep),
    "blink runs at each of its ticks; while beep keeps the only thread, one blink "
    "waits, the next ones are missed; after beep, one blink runs and all goes on",
    begin=1.5,
)

# %% [markdown]
# The **wait set** lists everything that the executor waits for, including the two timers. During a beep, the wait set's
# frame is dashed, because the executor isn't waiting: its only thread is busy with `beep`. One blink is waiting, and
# any further ticks are lost, because only one can wait.
#
# Five blinks were due during the beep, but four of them never came. After the beep, the blink timer is overdue, so its
# callback runs once. Then the timer returns to its schedule. The missed ticks are **dropped**.
#
# This design suits a robot: after a busy period, it needs one reading of the *current* tilt, not a burst of five.
#
# Still, the node did nothing else during the 1.1 s of each beep, so keep your callbacks short. Lesson 10 shows how to
# handle long-running work.
#
# **Your turn.** How long can the beep take before the node starts to drop blinks? Find the longest beep, to a tenth of
# a second, at which it drops none. One blink may be late.

# %% id="your-beep"
beep_takes_s = ...  # TODO: seconds, with one decimal

result = ...
if beep_takes_s is not ...:
    beep = {**long_beep, "beep_takes_s": beep_takes_s}
    seen = record(
        blink_and_beep, {BLINK: 0.2, BEEP: 2.0}, seconds=8.5, clock="wall", **beep
    )
    blinks, beeps = arrivals(seen, BLINK), arrivals(seen, BEEP)
    came = [sum(a - 0.1 < t < b - 0.1 for t in blinks) for a, b in pairwise(beeps[:4])]
    result = beep_takes_s, median(came)
yours(result, (0.3, 10), "It must end before a second blink is due, after 0.4 s.")

# %% [markdown]
# ## When it goes wrong
#
# **A call instead of a callback.** Can you find the mistake before you run the cell?


# %% tags=["raises-exception"]
class Eager(Node):
    """Wants to blink ten times a second."""

    def __init__(self) -> None:
        super().__init__("eager")
        self.create_timer(0.1, self.blink())

    def blink(self) -> None:
        print("blink!")


eager = fresh(Eager)
await run(eager, seconds=1)

# %% [markdown]
# You see one blink, followed by an error that mentions `NoneType`. `self.blink()` *calls* the method while the node is
# being created. The method returns `None`, so the timer's callback is `None`. rclpy doesn't raise the error until the
# first tick, so the traceback doesn't point to the line with the mistake. Without the parentheses, you pass the method
# itself:


# %%
class Patient(Node):
    """Blinks ten times a second."""

    def __init__(self) -> None:
        super().__init__("patient")
        self.blinks = 0
        self.create_timer(0.1, self.blink)

    def blink(self) -> None:
        self.blinks += 1


patient = fresh(Patient)
await run(patient, seconds=5, until=lambda: patient.blinks == 3)
print("blinks:", patient.blinks)

# %% [markdown]
# **A node that isn't spun.** This node has a timer, and all names are spelled correctly, but the callback never runs.

# %%
silent = fresh(Patient)
time.sleep(1.0)
print("blinks after a second:", silent.blinks)

# %% [markdown]
# The timer is due, but no executor is spinning the node, so nothing calls the callback. In a program,
# `rclpy.spin(node)` calls it; in these lessons, `run(node)` does. The next cell spins this node:

# %%
await run(silent, seconds=5, until=lambda: silent.blinks == 3)
print("blinks:", silent.blinks)

# %% [markdown]
# ## From a worked example to your own
#
# **Worked example.** A guide robot takes a step every half second and looks around every 2 s. Each of the two tasks has
# its own period, timer, and method.

# %%
STEP_PERIOD_S = 1 / 2.0  # 2 Hz
LOOK_PERIOD_S = 1 / 0.5  # 0.5 Hz


class Guide(Node):
    """Walks, and looks around now and then."""

    def __init__(self) -> None:
        super().__init__("guide")
        self.done: list[str] = []
        self.create_timer(STEP_PERIOD_S, self.make_step)
        self.create_timer(LOOK_PERIOD_S, self.look_around)

    def make_step(self) -> None:
        self.done.append("step")

    def look_around(self) -> None:
        self.done.append("look")


guide = fresh(Guide)
await run(guide, seconds=4.25)
print(guide.done.count("step"), "steps,", guide.done.count("look"), "looks")

# %% [markdown]
# **Fill in the blanks.** The guide should also talk, at 0.8 Hz. Replace each `...` with your code. Until you do, the cell
# prints a reminder.

# %%
TALK_PERIOD_S = ...  # TODO: seconds between two sentences at 0.8 Hz


class TalkingGuide(Guide):
    """Walks, looks around, and talks."""

    def __init__(self) -> None:
        super().__init__()
        if TALK_PERIOD_S is not ...:
            ...  # TODO: a timer that calls self.talk

    def talk(self) -> None:
        self.done.append("talk")


sentences = ...
if TALK_PERIOD_S is not ...:
    talking = fresh(TalkingGuide)
    await run(talking, seconds=4.25)
    sentences = talking.done.count("talk")
yours(sentences, 3, "In 4.25 s at 0.8 Hz, three sentences are due.")

# %% [markdown]
# **Your own.** In the [exercise](../exercises/05_timers.ipynb), a humanoid publishes its heartbeat, battery level, and
# tilt, each at a different rate. `%check` counts the messages that arrive in a minute of robot time.

# %% [markdown]
# ## Check yourself
#
# **1. `self.create_timer(0.25, self.beep)` creates a timer. How often does the timer call `beep`?**
#
# <details><summary>a) Every four seconds</summary>
#
# ✗ That would be 0.25 Hz. The number is a period, so a quarter of a second passes from one beep to the next.
#
# </details>
# <details><summary>b) Four times a second</summary>
#
# ✓ Yes: 1 divided by 0.25 s is 4 Hz.
#
# </details>
# <details><summary>c) Once, after a quarter of a second</summary>
#
# ✗ A timer keeps ticking until it is canceled or its node is destroyed.
#
# </details>
#
# **2. In each iteration, a loop works for 20 ms and then sleeps for 0.1 s. How many iterations fit into a minute?**
#
# <details><summary>a) 600</summary>
#
# ✗ It would be 600 if the work took no time.
#
# </details>
# <details><summary>b) 600, because the loop catches up near the end</summary>
#
# ✗ The loop has no schedule, so it can't catch up. It sleeps for 0.1 s every time.
#
# </details>
# <details><summary>c) At most 500</summary>
#
# ✓ Each iteration takes at least 0.12 s, and 60 / 0.12 is 500. `sleep(0.1)` may take a little more than 0.1 s, but
# never less.
#
# </details>
#
# **3. A timer ticks every 0.1 s. Once, its callback takes 0.35 s. What happens next?**
#
# <details><summary>a) One tick is late, and the following ones are on schedule again</summary>
#
# ✓ The schedule hasn't moved. The ticks in between are dropped.
#
# </details>
# <details><summary>b) Three ticks come in a row, to catch up</summary>
#
# ✗ A timer doesn't catch up, as you saw with the long beep.
#
# </details>
# <details><summary>c) From now on, every tick is 0.25 s late</summary>
#
# ✗ A loop that sleeps would behave like this. A timer keeps its schedule.
#
# </details>
#
# **4. You wrote `self.create_timer(1.0, self.beat)` without storing the result. What happens to the timer?**
#
# <details><summary>a) The garbage collector removes it sooner or later</summary>
#
# ✗ In this lesson, you ran the collector yourself, and the timer kept ticking.
#
# </details>
# <details><summary>b) It ticks as long as the node exists</summary>
#
# ✓ The node stores a reference to it. The node still has to be spun, of course.
#
# </details>
# <details><summary>c) It ticks once, because your code has no reference to it</summary>
#
# ✗ Your code has no reference, but the node does: `node.timers` lists all of its timers.
#
# </details>

# %% [markdown]
# ## Talk it through
#
# Write down your own answer first. Then give this prompt to an AI assistant, or discuss it with a colleague.
#
# ```text
# I'm programming a robot with ROS 2 Jazzy in Python (rclpy). My robot reads a distance
# sensor at 20 Hz and saves a camera image once a second, both with timers in one node.
# Saving takes between 30 and 200 ms. What will the distance readings look like, and
# what would you change? Make sure that every rclpy function you use exists in Jazzy.
# ```
#
# <details><summary>What a good answer covers</summary>
#
# The distance timer is due every 50 ms. While an image is being saved, the first distance tick is late, and up to three
# more are dropped. So once a second, there's a gap of up to a quarter of a second: the saving time plus one period. No
# burst follows the gap. Whether the gap matters depends on the robot's speed: at 1 m/s, the robot travels 25 cm in that
# time.
#
# There are two solutions. You can shorten the callback by passing the image to a thread or another process that saves
# it. Or you can run the two callbacks in different threads, with a multithreaded executor and separate callback groups
# (lesson 10). A shorter timer period doesn't help. Good answers also ask whether the robot has to save the image at
# all.
#
# </details>
#
# <details><summary>What to check in the reply</summary>
#
# Watch for these two claims. We tested both with the rclpy version that this course uses, and both are wrong.
#
# - **Missed ticks come later, in a burst:** No, they're dropped.
# - **You can keep the rate by calling `rate.sleep()` in the callback:** No. This call waits for a timer, but the thread
#   that would run that timer is itself waiting. So in a callback that `rclpy.spin` runs, `rate.sleep()` never returns.
#
# </details>

# %% [markdown]
# ## Take away
#
# - `create_timer(period, callback)`: the period is in seconds. The frequency, in hertz, is 1 divided by the period.
# - A timer follows a schedule, so it has jitter but no drift. A loop that calls `sleep` does drift.
# - A node can have many timers. Their callbacks share one thread and run one after another.
# - A slow callback delays the others. Missed ticks are dropped; they don't come later in a burst.
# - Pass the callback without parentheses, and spin the node.
#
# **Before:** [04 · Subscriptions and callbacks](04_subscriptions_and_callbacks.ipynb)
#
# **Next:** [06 · Spinning](06_spinning.ipynb): what calls a timer's callback, and when.
#
# **More:** [About executors](https://docs.ros.org/en/jazzy/Concepts/Intermediate/About-Executors.html), on what calls
# the timers' callbacks, and [clock and time](https://design.ros2.org/articles/clock_and_time.html), on simulated time.
