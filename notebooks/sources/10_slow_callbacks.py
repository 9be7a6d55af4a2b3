# %% [markdown]
# # 10 · Slow callbacks
#
# While a callback runs, the rest of its node waits. So where do you put work that takes a long time?
#
# - **Minutes:** 50
# - **You need:** lessons [05](05_timers.ipynb) and [08](08_humanoid_status_publisher.ipynb), and a basic idea of
#   threads, which let one program run several pieces of code at the same time
# - **You will be able to:**
#   - explain what a slow callback does to the rest of a node
#   - move slow work elsewhere
#   - choose between threads, callback groups, and a queue
#   - share data safely between two callbacks
# - **Not covered:** services (lesson 12), real-time scheduling

# %% [markdown]
# Here's a robot that waves. Every three seconds, it stops waving for one second to think about its next action.

# %%
from lesson_nodes import thinking_robot
from workbook.lesson import start, stop, watch_robot

print("started", start(thinking_robot, heartbeat_period_s=0.05))
await watch_robot(seconds=8, ease=0.0)
stop()

# %% [markdown]
# The code doesn't contain a command to stop the arm. The arm stops because the program is busy thinking. By the end of
# this lesson, the robot will think and wave at the same time.

# %% [markdown] prediction="two-nodes"
# ## Predict
#
# In lesson 05, a single thread ran all of a node's timer callbacks. This robot works the same way, but one of its
# callbacks is slow:
#
# ```python
# self.create_timer(0.1, self.beat)         # the heartbeat, 10 Hz
# self.create_timer(1.1, self.think)        # takes 1.0 s: a planner
# ```
#
# To rescue the heartbeat, a colleague moves it into a **separate node**. Both nodes stay in one program and share one
# executor:
#
# ```python
# executor = SingleThreadedExecutor()
# executor.add_node(Heart())
# executor.add_node(Thinker())
# executor.spin()
# ```
#
# In five seconds, 50 heartbeats are due. What happens?
#
# - **a** Nearly all arrive: the heart is a separate node now.
#   when `arrived >= 0.8 * due`
#   ✗ A node isn't a thread. One thread runs the callbacks of both nodes, and `think` keeps that thread busy.
# - **b** About half: the two nodes share the time.
#   when `due / 2 <= arrived < 0.8 * due`
#   ✗ `think` takes 1.0 s of every 1.1 s, and the executor can't interrupt it.
# - **c** Fewer than half: the second node makes no difference.
#   when `0 < arrived < due / 2`
#   ✓ The executor has one thread for all of its nodes. While that thread is in `think`, no other callback runs.
# - **d** None: an executor accepts only one node.
#   when `arrived == 0`
#   ✗ An executor accepts any number of nodes.

# %%
from workbook.lesson import predict, reveal

predict("two-nodes")

# %% [markdown]
# ## Run it
#
# `record` starts the program in its own process and records the arrival time of each message. This recording uses the
# wall clock, because `think` takes a second of real time.
#
# [the same without helpers: start, record]

# %%
from workbook.lesson import about, arrivals, record

HEARTBEAT, THOUGHT = "/robot/heartbeat", "/robot/thought"
SECONDS, DUE = 5.0, 50


def watch(**parameters):
    """Five seconds of a robot that thinks for 1 s, every 1.1 s."""
    periods = {HEARTBEAT: 0.1, THOUGHT: 1.1}
    return record(
        thinking_robot,
        periods,
        seconds=SECONDS,
        clock="wall",
        think_period_s=1.1,
        **parameters,
    )


def came(recording):
    """How many of the 50 heartbeats came that are due from the first one on."""
    times = arrivals(recording, HEARTBEAT)
    return sum(t < times[0] + SECONDS - 0.05 for t in times)


FEW, MOST = (1, DUE / 2), (0.6 * DUE, DUE + 1)
plain = watch()
beats, thoughts = arrivals(plain, HEARTBEAT), arrivals(plain, THOUGHT)
print("heartbeats that came:", about(came(plain), between=FEW), "of", DUE)

# %% [markdown]
# The program we just recorded has a single node. Here's the colleague's program, which has two:

# %%
# %%writefile two_nodes.py
import time

import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import String


class Heart(Node):
    def __init__(self) -> None:
        super().__init__("heart")
        self.publisher = self.create_publisher(String, "/robot/heartbeat", 10)
        self.create_timer(0.1, self.beat)

    def beat(self) -> None:
        self.publisher.publish(String(data="alive"))


class Thinker(Node):
    def __init__(self) -> None:
        super().__init__("thinker")
        self.create_timer(1.1, self.think)

    def think(self) -> None:
        time.sleep(1.0)


rclpy.init()
executor = SingleThreadedExecutor()
executor.add_node(Heart())
executor.add_node(Thinker())
executor.spin()

# %%
two_nodes = record("two_nodes.py", {HEARTBEAT: 0.1}, seconds=SECONDS, clock="wall")
reveal("two-nodes", arrived=came(two_nodes), due=DUE)

# %% id="flat-line"
from itertools import pairwise

print("two nodes: heartbeats:", about(came(two_nodes), between=FEW), "of", DUE)
silence_s = max(b - a for a, b in pairwise(beats))
print("one node: longest silence:", about(silence_s, "s", between=(0.9, 3)))

# %% [markdown]
# ## Look inside

# %%
from workbook.pictures.figures import show
from workbook.pictures.timeline import strip

show(
    strip({HEARTBEAT: beats, THOUGHT: thoughts}, periods={HEARTBEAT: 0.1}, end=SECONDS),
    "heartbeats: a regular row at first, "
    "then a silence of a second during each thought",
)

# %% [markdown]
# No heartbeat arrived during the shaded intervals. `rclpy.spin` is a loop in **one thread**. In essence, the loop looks
# like this:
#
# ```python
# while rclpy.ok():
#     callback = wait_until_one_is_due()
#     callback()                            # nothing else happens until this returns
# ```
#
# A timer doesn't *run*. It's just an entry in a list: "due at 3.2 s". While `think` occupies the thread, the executor
# doesn't check the list or take messages from any queue.
#
# When `think` returns, the loop checks the list again. What happens to the ten heartbeats that were due while `think`
# was running?

# %% id="no-burst"
bursts = sum(beats[n + 2] - beats[n] < 0.05 for n in range(len(beats) - 2))
print("bursts, three heartbeats or more within 0.05 s:", bursts)

# %% [markdown]
# All but one of the ten heartbeats are dropped. The heartbeat timer is overdue, so it fires once and then returns to
# its schedule. It doesn't make up for missed **ticks**. **Messages** that arrive in the meantime aren't dropped: they
# wait in the subscription's queue, up to its depth. The executor handles them later, one by one.
#
# So *keep callbacks short*: store or publish something, and return. But some work takes a long time: planning a path,
# running a neural network, or waiting for a gripper. The rest of this lesson shows where to put such work.

# %% [markdown] prediction="four-threads"
# ## Change it
#
# ### Experiment 1: more threads
#
# rclpy also has an executor that uses several threads. Here's the complete `main()`:
#
# ```python
# def main() -> None:
#     rclpy.init()
#     executor = MultiThreadedExecutor(num_threads=4)
#     executor.add_node(ThinkingRobot())
#     try:
#         executor.spin()
#     except (KeyboardInterrupt, ExternalShutdownException):
#         pass
#     finally:
#         rclpy.try_shutdown()
# ```
#
# (You may also read about an `EventsExecutor`. Don't use it: it's experimental, and when we tested it with this build,
# its `spin` didn't run any callbacks.)
#
# The node doesn't change. How many of the 50 heartbeats arrive now?
#
# - **a** Nearly all of them: one thread runs `think`, and the other three are free.
#   when `arrived >= 0.8 * due`
#   ✗ Three threads are free, but both callbacks are in the node's default group, which runs only one callback at a
#   time.
# - **b** Twice as many as before.
#   when `due / 2 <= arrived < 0.8 * due`
#   ✗ More threads make no difference here. Both callbacks are in the same group, and that group never runs two
#   callbacks at the same time.
# - **c** No more than with one thread.
#   when `arrived < due / 2`
#   ✓ Unless you choose another group, all of a node's callbacks share one mutually exclusive group. So three of the
#   four threads stay idle.

# %%
predict("four-threads")

# %% id="more-threads"
counted = {"1 thread": came(plain)}
counted["4 threads"] = came(watch(threads=4))
print("with four threads:", about(counted["4 threads"], between=FEW), "of", DUE)
reveal("four-threads", arrived=counted["4 threads"], due=DUE)

# %% id="machine-of-four-threads"
from workbook.lesson import record_machine, show_machine

thinking = {"think_period_s": 1.1, "threads": 4}
show_machine(
    record_machine(thinking_robot, seconds=2.2, **thinking),
    "the heart beats until think begins; then one thread runs think, three are free, "
    "and the wait set has no place for the heart, whose ticks are missed",
    begin=0.7,
)

# %% [markdown]
# Look at the wait set, the list of everything that the executor waits for, while `think` is running. Where the
# heartbeat timer was, there's now a dash, because the executor doesn't even check that timer.
#
# Three of the four threads are idle. That's because each callback belongs to a **callback group**. Unless you choose
# another group, a callback belongs to the node's default group. This group is *mutually exclusive*: only one of its
# callbacks runs at a time, no matter how many threads there are. So unless you *explicitly* allow it, a node's
# callbacks never run in parallel.

# %% [markdown] prediction="own-group"
# ### Experiment 2: a separate group
#
# ```python
# from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
#
#         thinking = MutuallyExclusiveCallbackGroup()
#         self.create_timer(0.1, self.beat)
#         self.create_timer(1.1, self.think, callback_group=thinking)
# ```
#
# With these lines, `beat` is in the default group, and `think` is alone in another group. Let's run four programs, one
# for each combination: with or without this separate group, and with one thread or four. Which of them have a steady
# heartbeat?
#
# - **a** Only the program with the separate group and four threads.
#   when `one_thread < 0.6 * due and four_threads >= 0.6 * due`
#   ✓ The separate group permits both callbacks to run at the same time, and a second thread makes that possible.
#   Neither is enough by itself.
# - **b** None of them: thinking still takes a second.
#   when `one_thread < 0.6 * due and four_threads < 0.6 * due`
#   ✗ Thinking does take a second, but with a separate group and a second thread, the heartbeat no longer waits for
#   `think`.
# - **c** Both programs with the separate group: one thread is enough.
#   when `one_thread >= 0.6 * due`
#   ✗ A group gives permission, but it doesn't add a thread. With one thread, the heartbeat still waits until `think`
#   returns.

# %%
predict("own-group")

# %%
counted["1 thread, own group"] = came(watch(own_group=True))
grouped = watch(threads=4, own_group=True)
counted["4 threads, own group"] = came(grouped)

for name, count in counted.items():
    usual = MOST if name == "4 threads, own group" else FEW
    print(f"{name}:", about(count, between=usual), "of", DUE)
reveal(
    "own-group",
    one_thread=counted["1 thread, own group"],
    four_threads=counted["4 threads, own group"],
    due=DUE,
)

# %%
from workbook.pictures.figures import figure
from workbook.pictures.palette import GREEN, GREY, RED

fig, axes = figure(6.4, 2.2)
colors = [GREEN if count >= MOST[0] else RED for count in counted.values()]
bars = axes.barh(list(counted), list(counted.values()), color=colors, height=0.6)
signs = [f"{'✓' if count >= MOST[0] else '✗'} {count}" for count in counted.values()]
axes.bar_label(bars, signs, padding=4)
axes.axvline(DUE, linestyle="--", color=GREY)
axes.set(xlabel="heartbeats that came, of 50 that were due", xlim=(0, 58))
axes.grid(visible=False)
axes.invert_yaxis()
axes.set_title("The heart needs both: threads and a group of its own", fontsize=11)
show(
    fig,
    "four bars: only four threads together with a group of its own "
    "bring most heartbeats",
)

# %% id="machine-with-own-group"
show_machine(
    record_machine(thinking_robot, seconds=2.2, own_group=True, **thinking),
    "while one thread runs think, a second one runs each beat of the heart, on time",
    begin=0.7,
)

# %% [markdown]
# Threads make it *possible* to run two callbacks at the same time, and groups *permit* it. You need both. Here are two
# recordings side by side: one without extra threads or a separate group, and one with both. Each robot moves a little
# whenever one of its heartbeats arrives:

# %%
from workbook.pictures.moving import by_name, robots

robots(
    by_name(
        {"1 thread": beats, "4 threads, own group": arrivals(grouped, HEARTBEAT)},
        period=0.1,
    ),
    "two robots: one stands still with a red lamp during each thought, "
    "the other one moves all the time",
    end=SECONDS,
)

# %% [markdown]
# **Your turn.** Here's a smaller robot with the same two timers. Put `think` into a separate group, and give the
# executor enough threads. The cell counts how often the heart pauses for more than half a second.
#
# [the same without helpers: init, fresh]

# %% id="your-group"
import time

from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor, SingleThreadedExecutor
from rclpy.node import Node

from workbook.lesson import fresh, init, yours

init()
group = ...  # TODO: a callback group
threads = ...  # TODO: a number


class SmallRobot(Node):
    """Beats ten times a second, and thinks for a second."""

    def __init__(self, group) -> None:
        super().__init__("small_robot")
        self.beats: list[float] = []
        self.create_timer(0.1, lambda: self.beats.append(time.monotonic()))
        self.create_timer(1.1, lambda: time.sleep(1.0), callback_group=group)


def spin_with(executor, node, seconds):
    """Let an executor serve a node for some seconds."""
    executor.add_node(node)
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        executor.spin_once(timeout_sec=0.1)
    executor.remove_node(node)
    time.sleep(0.2)  # let callbacks that are running finish
    executor.shutdown()


pauses = ...
if ... not in (group, threads):
    small = fresh(SmallRobot, group)
    spin_with(MultiThreadedExecutor(num_threads=threads), small, 4.0)
    pauses = sum(b - a > 0.5 for a, b in pairwise(small.beats))
yours(pauses, 0, "MutuallyExclusiveCallbackGroup(), and two threads")

# %% [markdown]
# How many threads does the waving robot need? Move the slider while the cell runs.

# %%
from workbook.lesson import knob

settings = {"heartbeat_period_s": 0.05, "own_group": True}
await knob(thinking_robot, "threads", 1, between=(1, 4), seconds=8, **settings)

# %% [markdown]
# ### Experiment 3: two threads, one number
#
# There's a second kind of group. In a **reentrant** group, all callbacks may run in parallel, and even two calls to the
# same callback may overlap.
#
# A robot counts its steps. Each foot has a timer, and both timer callbacks add to the same number:

# %%
class StepCounter(Node):
    """Counts the steps of two feet in one number."""

    def __init__(self, name, group) -> None:
        super().__init__(name)
        self.called: list[str] = []
        self.steps = 0
        self.create_timer(0.010, lambda: self.on_step("left"), callback_group=group)
        self.create_timer(0.010, lambda: self.on_step("right"), callback_group=group)

    def on_step(self, foot) -> None:
        self.called.append(foot)
        steps = self.steps  # read,
        time.sleep(0.002)  # look up the length of the step,
        self.steps = steps + 1  # and write


# %% [markdown] prediction="the-steps"
# In two seconds, `on_step` is called about 400 times. With four threads and a reentrant group, what's the value of
# `steps` at the end?
#
# - **a** The number of calls: Python's global interpreter lock (GIL) prevents errors.
#   when `0.9 * calls <= steps <= calls`
#   ✗ The GIL lets only one thread run at a time. But Python may switch threads after one thread has read `steps` and
#   before it writes the new value.
# - **b** Far less than the number of calls.
#   when `steps < 0.9 * calls`
#   ✓ If two threads read the same number, both add one and write the same result. So one step is lost.
# - **c** More than the number of calls.
#   when `steps > calls`
#   ✗ Each call adds at most one, so steps can get lost, but no extra ones can appear.

# %%
predict("the-steps")

# %% id="race"
free = fresh(StepCounter, "reentrant_counter", ReentrantCallbackGroup())
spin_with(MultiThreadedExecutor(num_threads=4), free, 2.0)

single = fresh(StepCounter, "exclusive_counter", MutuallyExclusiveCallbackGroup())
spin_with(MultiThreadedExecutor(num_threads=4), single, 2.0)
for name, counter in (("reentrant", free), ("mutually exclusive", single)):
    calls = about(len(counter.called), "calls", between=(50, 410), digits=3)
    lost = len(counter.called) - counter.steps
    if counter is free:
        lost = about(lost, between=(5, 300))
    print(f"{name}: {calls}, steps lost: {lost}")
reveal("the-steps", steps=free.steps, calls=len(free.called))

# %% [markdown]
# Suppose two threads both read 41. Both add one, and both write 42, so one step is lost. This is a **race**: the result
# depends on the order in which the threads happen to run. No exception is raised, and a short test may never reveal the
# race.
#
# Python's global interpreter lock (GIL) doesn't protect *your* three lines, because Python may switch threads between
# any two of them. But you can create your own lock, which only one thread can hold at a time.
#
# **Your turn.** Make the reentrant counter safe. The class below wraps the three lines in a `with lock:` block.

# %% id="your-lock"
import threading

lock = ...  # TODO: a lock from the module threading


class LockedCounter(StepCounter):
    """Counts with a lock."""

    def on_step(self, foot) -> None:
        with lock:
            super().on_step(foot)


lost = ...
if lock is not ...:
    locked = fresh(LockedCounter, "locked_counter", ReentrantCallbackGroup())
    spin_with(MultiThreadedExecutor(num_threads=4), locked, 2.0)
    lost = len(locked.called) - locked.steps
yours(lost, 0, "threading.Lock()")

# %% [markdown]
# Here are the rules for shared data:
#
# - Put callbacks that share data into **one** mutually exclusive group. Then you don't need a lock.
# - If callbacks in two groups have to share data, protect the data with a lock (`with self.lock:`), or pass it through
#   a `queue.Queue`.
# - Use a reentrant group only for callbacks that share nothing.

# %% [markdown]
# ## When it goes wrong
#
# **More threads, but no speedup.** While a planner *waits* for a sensor or another program, the processor is free for
# other work. While it *computes*, the processor is busy. Let's run four callbacks, on a single thread and on four
# threads. In the first test, all of the callbacks wait. In the second one, all of them compute in Python:


# %%
import itertools
from collections import Counter


class Planner(Node):
    """Plans in four callbacks at once, if the executor has the threads."""

    def __init__(self, name, job) -> None:
        super().__init__(name)
        self.plans: list[int] = []
        self.job = job
        for leg in range(4):
            own = MutuallyExclusiveCallbackGroup()
            self.create_timer(0.001, lambda leg=leg: self.plan(leg), callback_group=own)

    def plan(self, leg) -> None:
        self.job()
        self.plans.append(leg)


def wait() -> None:
    time.sleep(0.050)


def compute() -> None:
    sum(n * n for n in range(100_000))


done = Counter()
for _ in range(4):  # by turns, so that a busy moment slows all of them down
    for job, threads in itertools.product((wait, compute), (1, 4)):
        planner = fresh(Planner, f"{job.__name__}_{threads}", job)
        if threads == 1:
            executor = SingleThreadedExecutor()
        else:
            executor = MultiThreadedExecutor(num_threads=threads)
        spin_with(executor, planner, 0.5)
        done[job.__name__, threads] += len(planner.plans)

# %% id="computing"
for (name, threads), plans in done.items():
    count = about(plans, "plans", between=(5, 3000))
    print(f"{name} in {threads} thread{'s' * (threads > 1)}: {count}")
for name, usual in (("wait", (2, 4.5)), ("compute", (0.2, 2))):
    times = about(done[name, 4] / done[name, 1], "times", between=usual)
    print(f"{name}: four threads make {times} the plans of one")

# %% [markdown]
# Because of the GIL, only one thread at a time can run Python code. So four threads can wait at the same time, but they
# can't compute at the same time. If a computation must not delay the heartbeat, run it in **another process**. (NumPy
# and most AI libraries release the GIL while they compute, so measure before you choose.)
#
# **Exceptions in a thread pool go unreported.** A callback can also hand slow work off to a separate thread or to a
# thread pool. In this program, every plan fails:

# %%
from workbook.lesson import run_program

POOL = """
import time
from concurrent.futures import ThreadPoolExecutor

import rclpy
from rclpy.node import Node


class Robot(Node):
    def __init__(self) -> None:
        super().__init__("robot")
        self.beats = 0
        self.asked = 0
        self.planned = 0
        self.pool = ThreadPoolExecutor(max_workers=1)
        self.create_timer(0.1, self.beat)
        self.create_timer(0.5, self.on_request)

    def beat(self) -> None:
        self.beats += 1

    def on_request(self) -> None:
        self.asked += 1
        self.pool.submit(self.plan)  # hand it over, return at once

    def plan(self) -> None:
        time.sleep(0.05)
        raise RuntimeError("there is no path to the desk")
        self.planned += 1


rclpy.init()
robot = Robot()
end = time.monotonic() + 3.0
while time.monotonic() < end:
    rclpy.spin_once(robot, timeout_sec=0.1)
print(robot.beats, robot.asked, robot.planned)
rclpy.try_shutdown()
"""

# %% id="dead-brain"
outcome = run_program(POOL, seconds=40)
beats, asked, planned = map(int, outcome.log.splitlines()[0].split())
print("heartbeats:", about(beats, between=(10, 31)))
print("plans asked for:", about(asked, between=(2, 6), digits=1))
print("plans made:", planned)
print("errors in the log:", outcome.log.count("RuntimeError"))

# %% [markdown]
# There's no plan, no error message, and no traceback, yet the heartbeat is perfect. The pool stores the exception in
# the *future* that `submit` returns, and the program never reads that future. With a `threading.Thread`, you'd get a
# traceback. But the exception would also end the thread, as in [lesson 08](08_humanoid_status_publisher.ipynb).
#
# Handle exceptions in the thread that does the work:

# %%
FIXED = POOL.replace(
    "    def plan(self) -> None:",
    """    def plan(self) -> None:
        try:
            self.find_path()
        except Exception as error:
            self.get_logger().error(f"planning failed: {error}")

    def find_path(self) -> None:""",
)
outcome = run_program(FIXED, seconds=40)
failures = [line for line in outcome.log.splitlines() if "planning failed" in line]
print(failures[0])
print("failures logged:", about(len(failures), between=(2, 6), digits=1))

# %% [markdown]
# A heartbeat proves only that its own timer is running. To make it a sign of the planner's health, too, publish `alive`
# only while the planner is working properly.

# %% [markdown]
# ## From a worked example to your own
#
# **Worked example.** A guide robot plans a path on request. The solution has two parts: a group for the slow callback
# and an executor with two threads. The callbacks share no data: `beat` uses only `self.beats`, and `on_goal` uses only
# `self.paths`.

# %%
from std_msgs.msg import String

from workbook.lesson import run


class Guide(Node):
    """Beats ten times a second, and plans a path when asked."""

    def __init__(self) -> None:
        super().__init__("guide")
        self.beats = 0
        self.paths: list[str] = []
        planning = MutuallyExclusiveCallbackGroup()
        self.create_timer(0.1, self.beat)
        self.create_subscription(
            String, "/guide/goal", self.on_goal, 10, callback_group=planning
        )

    def beat(self) -> None:
        self.beats += 1

    def on_goal(self, message: String) -> None:
        time.sleep(0.8)  # the planner
        self.paths.append(message.data)


guide = fresh(Guide)
visitor = fresh(Node, "visitor")
asking = visitor.create_publisher(String, "/guide/goal", 10)
await run(visitor, until=lambda: asking.get_subscription_count() == 1)
for goal in ("desk", "lift", "stairs"):
    asking.publish(String(data=goal))

spin_with(MultiThreadedExecutor(num_threads=2), guide, 4.0)
print("paths:", guide.paths)
print("heartbeats in 4 s:", about(guide.beats, between=(20, 42)))

# %% [markdown]
# With one thread, only about 20 of the 40 heartbeats would have been published. Three requests arrived at the same
# time. Two of them waited in the subscription's queue, and the robot planned all three paths in order. The *mutually
# exclusive* group guarantees that order.
#
# **Fill in the blanks.** This version uses a queue and its own worker thread. The callbacks just hand off the work, so
# *one* thread is enough for them, and a plain `run` will do. Replace each `...` with your code.
#
# [the same without helpers: run]

# %% id="your-queue"
import queue


class QueueGuide(Node):
    """Beats ten times a second; a worker thread plans what is in the queue."""

    def __init__(self) -> None:
        super().__init__("queue_guide")
        self.beats = 0
        self.paths: list[str] = []
        self.goals: queue.Queue[str] = queue.Queue()
        self.create_timer(0.1, self.beat)
        self.create_subscription(String, "/guide/goal", self.on_goal, 10)
        threading.Thread(target=self.work, daemon=True).start()

    def beat(self) -> None:
        self.beats += 1

    def on_goal(self, message: String) -> None:
        ...  # TODO: put the goal into the queue, and return at once

    def work(self) -> None:
        while True:
            goal = ...  # TODO: wait for the next goal in the queue
            if goal is ...:
                return
            time.sleep(0.8)  # the planner
            self.paths.append(goal)


queue_guide = fresh(QueueGuide)
# Two subscriptions: the guide from above listens, too.
await run(visitor, until=lambda: asking.get_subscription_count() == 2)
for goal in ("desk", "lift", "stairs"):
    asking.publish(String(data=goal))
await run(queue_guide, seconds=4.0)
yours(
    queue_guide.paths or ...,
    ["desk", "lift", "stairs"],
    "self.goals.put(message.data), and goal = self.goals.get()",
)

# %% [markdown]
# **Your own.** In the [exercise](../exercises/10_slow_callbacks.ipynb), a humanoid's heartbeat stops whenever the robot
# plans an arm movement. The judge checks two things from outside the program: that the heartbeats keep coming and that
# each plan is correct.

# %% [markdown]
# ## Check yourself
#
# **1. A callback calls `self.pool.submit(self.plan)`, and `plan` raises an exception. What do you see?**
#
# <details><summary>a) No plan, and no traceback</summary>
#
# ✓ The exception is stored in the future that `submit` returned. Catch it in `plan`, and log it there.
#
# </details>
# <details><summary>b) <code>spin</code> raises the exception, and the program ends</summary>
#
# ✗ That happens if the callback itself raises an exception. This callback only handed off the work.
#
# </details>
# <details><summary>c) A traceback, and then no more plans, because the pool's thread has ended</summary>
#
# ✗ That's what happens with a `threading.Thread`. A pool stores the exception, and its thread takes the next task.
#
# </details>
#
# **2. You spin one node with a `MultiThreadedExecutor` that has eight threads. How do the node's callbacks run?**
#
# <details><summary>a) Timer callbacks at the same time, subscription callbacks one at a time</summary>
#
# ✗ Callback groups don't distinguish between kinds of callbacks.
#
# </details>
# <details><summary>b) Up to eight at the same time</summary>
#
# ✗ That requires permission: separate groups, or a reentrant group.
#
# </details>
# <details><summary>c) One at a time, as with <code>rclpy.spin</code></summary>
#
# ✓ All of them are in the node's default group, which is mutually exclusive.
#
# </details>
#
# **3. Two callbacks in two groups both run `self.steps += 1`. The executor has four threads. Is that safe?**
#
# <details><summary>a) Yes: the GIL lets only one thread run Python code</summary>
#
# ✗ Only one thread runs at a time, but Python may switch threads between the read and the write.
#
# </details>
# <details><summary>b) No: put both into one group, or protect the line with a lock</summary>
#
# ✓ Either one works. If the callbacks are short, putting both into one group is simpler.
#
# </details>
# <details><summary>c) Yes: both groups are mutually exclusive</summary>
#
# ✗ A mutually exclusive group keeps only its own callbacks from overlapping, and these two are in different groups.
#
# </details>
#
# **4. `on_goal` takes 0.8 s and is alone in a mutually exclusive group. The executor has four threads. Three goals arrive. What happens?**
#
# <details><summary>a) Three threads plan for them at the same time</summary>
#
# ✗ That would require a reentrant group. A mutually exclusive group runs one call at a time, even if all calls are to
# the same callback.
#
# </details>
# <details><summary>b) The robot plans for the first goal, and the other two are lost</summary>
#
# ✗ A busy group doesn't lose messages. They wait in their subscription's queue, up to its depth.
#
# </details>
# <details><summary>c) The robot plans for the goals one after another, in the order in which they arrived</summary>
#
# ✓ Two goals wait in the subscription's queue. The last plan is ready after about 2.4 s.
#
# </details>

# %% [markdown]
# ## Talk it through
#
# Read this prompt and write down your own answer. Then copy the prompt into an AI assistant, or discuss it with a
# colleague.
#
# ```text
# I'm programming a robot with ROS 2 Jazzy in Python (rclpy). My robot publishes a
# heartbeat at 10 Hz and subscribes to goals. Planning takes 0.8 s and sometimes raises
# an exception. Goals may arrive faster than I can plan. Compare three designs: a callback
# group with a MultiThreadedExecutor, a worker thread with a queue, and a second process.
# In each design, what happens to the order of goals, to an exception, and to the goals
# that are waiting? Make sure that every rclpy function you use exists in Jazzy.
# ```
#
# <details><summary>What a good answer covers</summary>
#
# *Group and threads:* Goals wait in the subscription's queue, and once it's full, the oldest ones are lost. The goals
# stay in order as long as the group is mutually exclusive. An exception propagates out of `spin` and ends the program.
# *Queue and worker:* The queue can grow long, so the robot may still be planning paths to goals that are a minute old.
# The worker must handle exceptions, or the first one ends its thread. *Process:* The heartbeat survives even a planner
# crash, but another program has to detect the crash and restart the planner. A good answer asks whether it's worth
# planning for an old goal at all. Often, only the newest goal counts. In that case, use a queue depth of 1. A good
# answer doesn't propose a reentrant group, because two calls would then use the same planner at the same time.
#
# </details>
#
# <details><summary>What to check in the reply</summary>
#
# Watch for these two claims. We tested both with this course's rclpy, and both are wrong.
#
# - **Replacing the executor with a `MultiThreadedExecutor` is enough:** Unless you choose other groups, all of a node's
#   callbacks are in one mutually exclusive group. They still run one at a time.
# - **The executor logs an exception in a callback and continues:** In fact, `spin` raises the exception. If your
#   program doesn't catch it, the program ends.
#
# </details>

# %% [markdown]
# ## Take away
#
# - While a callback runs, its thread does nothing else. Timer ticks that are due during that time are dropped.
# - A `MultiThreadedExecutor` alone changes nothing. Slow work needs its own callback group **and** a second thread.
# - Put callbacks that share data into one mutually exclusive group, or protect the data with a lock, or pass it through
#   a queue.
# - Python threads can wait at the same time, but they can't compute at the same time. Put heavy computation into a
#   separate process.
# - Handle exceptions in the thread that does the work.
#
# **Before:** [09 · The joint positions](09_joint_positions.ipynb)
#
# **Next:** [11 · Polling and callbacks](11_polling_against_callbacks.ipynb): what if you polled in a loop instead?
#
# **More:** [Using callback groups](https://docs.ros.org/en/jazzy/How-To-Guides/Using-callback-groups.html) and [About
# executors](https://docs.ros.org/en/jazzy/Concepts/Intermediate/About-Executors.html).
