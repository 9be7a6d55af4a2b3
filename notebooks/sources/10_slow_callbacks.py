# %% [markdown]
# # 10 · Slow callbacks
#
# While a callback runs, the rest of its node waits. Where do you put work that takes long?
#
# - **Minutes:** 50
# - **You need:** lessons [05](05_timers.ipynb) and [08](08_humanoid_status_publisher.ipynb), and what a thread is:
#   a second line of execution in the same program
# - **You will be able to:**
#   - say what a slow callback does to the rest of a node
#   - move slow work elsewhere
#   - choose between threads, callback groups and a queue
#   - say how two callbacks may share data
# - **Left out:** services (lesson 12), real-time scheduling

# %% [markdown]
# Watch the robot wave. Every three seconds it stops to think of what to do next. A thought takes one second.

# %%
from lesson_nodes import thinking_robot
from workbook.lesson import start, stop, watch_robot

print("started", start(thinking_robot, heartbeat_period_s=0.05))
await watch_robot(seconds=8, ease=0.0)
stop()

# %% [markdown]
# No line of the program stops the arm. It stops because the robot thinks. By the end of this lesson it will do both.

# %% [markdown] prediction="two-nodes"
# ## Predict
#
# You know from lesson 05 that one thread serves all timers of a node. In this robot one of them is slow:
#
# ```python
# self.create_timer(0.1, self.beat)         # the heartbeat, 10 Hz
# self.create_timer(1.1, self.think)        # takes 1.0 s: a planner
# ```
#
# A colleague wants to rescue the heartbeat, and moves it into a **node of its own**. Both nodes stay in one program and in
# one executor:
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
#   ✗ A node is not a thread. One thread serves both nodes, and it is busy while one of them thinks.
# - **b** About half: the two nodes share the time.
#   when `due / 2 <= arrived < 0.8 * due`
#   ✗ A thought takes 1.0 s of every 1.1 s, and the executor does not interrupt it.
# - **c** Fewer than half, as before.
#   when `0 < arrived < due / 2`
#   ✓ The executor has one thread for all its nodes. While it is in `think`, no other callback runs.
# - **d** None: an executor takes one node only.
#   when `arrived == 0`
#   ✗ An executor takes any number of nodes.

# %%
from workbook.lesson import predict, reveal

predict("two-nodes")

# %% [markdown]
# ## Run it
#
# `record` starts the program as a process of its own and notes when each message arrives. This time on the wall clock,
# because a thought takes real time.

# %%
from workbook.lesson import arrivals, record

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


plain = watch()
beats, thoughts = arrivals(plain, HEARTBEAT), arrivals(plain, THOUGHT)
print("heartbeats due:", DUE)

# %% tags=["nbval-ignore-output"]
print("heartbeats that came:", came(plain))

# %% [markdown]
# That was one node. Now the colleague's program with two:

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

silences = [b - a for a, b in pairwise(beats)]
print("fewer than half of the heartbeats came:", came(plain) < DUE / 2)
print("two nodes: fewer than half of the heartbeats came:", came(two_nodes) < DUE / 2)
print(
    "silences of 0.9 s and more:",
    "several" if sum(silence > 0.9 for silence in silences) >= 2 else "hardly any",
)

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
# In the shaded times no heartbeat came. `rclpy.spin` is a loop in **one thread**. In short it does this:
#
# ```python
# while rclpy.ok():
#     callback = wait_until_one_is_due()
#     callback()                            # nothing else happens until this returns
# ```
#
# A timer does not *run*. It is an entry in a list: "due at 3.2 s". While `think` occupies the thread, the list is not
# checked, and no message is taken from a queue.
#
# After the thought the loop checks the list again. What does it do with the ten heartbeats that it missed?

# %% id="no-burst"
bursts = sum(beats[n + 2] - beats[n] < 0.05 for n in range(len(beats) - 2))
print("bursts, three heartbeats or more within 0.05 s:", bursts)

# %% [markdown]
# Nothing. The timer is late, so it ticks once, and then goes back to its plan. Missed **ticks** are dropped. Missed
# **messages** are different. They wait in the queue of the subscription, as many as its depth allows. Then they are
# handled late, one by one.
#
# So *keep callbacks short*: store something, publish something, return. But some work is long: planning a path, running a
# neural network, waiting for a gripper. The rest of this lesson is about where to put it.

# %% [markdown] prediction="four-threads"
# ## Change it
#
# ### Experiment 1: more threads
#
# rclpy has an executor with several threads. The complete `main()` looks like this:
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
# (The name `EventsExecutor` appears in newer texts. In this build of rclpy it runs no callback at all: 0 of 30 ticks in
# three seconds. Do not use it.)
#
# The node stays as it is. How many of the 50 heartbeats arrive now?
#
# - **a** Nearly all of them: one thread thinks, three are free.
#   when `arrived >= 0.8 * due`
#   ✗ Threads are free, but both callbacks are in one group, the default one. It allows one callback at a time.
# - **b** Twice as many as before.
#   when `due / 2 <= arrived < 0.8 * due`
#   ✗ The number of threads changes nothing here. Both timers are in a group that excludes them from each other.
# - **c** As few as before.
#   when `arrived < due / 2`
#   ✓ All callbacks of a node share one mutually exclusive group unless you say otherwise. Three threads have nothing
#   to do.

# %%
predict("four-threads")

# %%
counted = {"1 thread": came(plain)}
counted["4 threads"] = came(watch(threads=4))
reveal("four-threads", arrived=counted["4 threads"], due=DUE)

# %% id="more-threads"
print("with four threads, fewer than half came:", counted["4 threads"] < DUE / 2)

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
# Look at the wait set during the thought: a dash stands where the heart was. The executor does not even ask for it.
#
# Four threads, and three of them idle. Each callback belongs to a **callback group**. If you name none, it is the node's default group, the same for all of
# them. This group is *mutually exclusive*: one of its callbacks runs at a time, however many threads there are.
# With this default, callbacks of a node never run at the same time. You have to *say* which ones may run in parallel.

# %% [markdown] prediction="own-group"
# ### Experiment 2: a group of its own
#
# ```python
# from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
#
#         thinking = MutuallyExclusiveCallbackGroup()
#         self.create_timer(0.1, self.beat)
#         self.create_timer(1.1, self.think, callback_group=thinking)
# ```
#
# Now `beat` is in the default group, and `think` is alone in another one. Which program keeps its heartbeat?
#
# - **a** Only the one with this line and several threads.
#   when `one_thread < 0.6 * due and four_threads >= 0.6 * due`
#   ✓ The group permits both at the same time, and a second thread makes it happen. It takes both.
# - **b** None: thinking still takes a second.
#   when `one_thread < 0.6 * due and four_threads < 0.6 * due`
#   ✗ The thought does take a second, but with a group of its own and a second thread it no longer holds up the beat.
# - **c** With this line, any: one thread is enough, since the groups are separate.
#   when `one_thread >= 0.6 * due`
#   ✗ A group is a permission, not a thread. With one thread, the beat still waits for the thought.

# %%
predict("own-group")

# %%
MOST = 0.6 * DUE  # so many count as "most of them"
counted["1 thread, own group"] = came(watch(own_group=True))
grouped = watch(threads=4, own_group=True)
counted["4 threads, own group"] = came(grouped)

for name, count in counted.items():
    fewer = "fewer than half" if count < DUE / 2 else count
    print(f"{name + ':':<22}", "most of them" if count >= MOST else fewer)
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
colors = [GREEN if count >= MOST else RED for count in counted.values()]
bars = axes.barh(list(counted), list(counted.values()), color=colors, height=0.6)
signs = [f"{'✓' if count >= MOST else '✗'} {count}" for count in counted.values()]
axes.bar_label(bars, signs, padding=4)
axes.axvline(DUE, linestyle="--", color=GREY)
axes.set(xlabel="heartbeats that came, of 50 that were due", xlim=(0, 58))
axes.grid(visible=False)
axes.invert_yaxis()
axes.set_title("only threads and a group together rescue the heart", fontsize=11)
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
# Threads make it *possible* to run two callbacks at once, groups *permit* it. You need both. Here are the two recordings
# side by side. Each robot moves a little at each heartbeat that arrived:

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
# How many threads does it take? Move the slider while the cell runs.

# %%
from workbook.lesson import knob

settings = {"heartbeat_period_s": 0.05, "own_group": True}
await knob(thinking_robot, "threads", 1, between=(1, 4), seconds=8, **settings)

# %% [markdown]
# ### Experiment 3: two threads, one number
#
# There is a second kind of group. In a **reentrant** group all callbacks may run in parallel, even one with itself.
#
# A robot counts its steps. Each foot has a timer, and both feet add to the same number:

# %%
import time

from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor, SingleThreadedExecutor
from rclpy.node import Node

from workbook.lesson import fresh, init

init()


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


def spin_with(executor, node, seconds):
    """Let an executor serve a node for some seconds."""
    executor.add_node(node)
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        executor.spin_once(timeout_sec=0.1)
    executor.remove_node(node)
    time.sleep(0.2)  # let callbacks that are running finish
    executor.shutdown()


# %% [markdown] prediction="the-steps"
# In two seconds `on_step` is called about 400 times. With four threads and a reentrant group, what will `steps` be?
#
# - **a** The number of calls: Python has a lock of its own, the GIL, so nothing can go wrong.
#   when `0.9 * calls <= steps <= calls`
#   ✗ The GIL lets one thread run at a time, but it may change threads between reading `steps` and writing it.
# - **b** Much less than the number of calls.
#   when `steps < 0.9 * calls`
#   ✓ Two threads read the same number, both add one, and both write the same result. One step is lost.
# - **c** More than the number of calls.
#   when `steps > calls`
#   ✗ Each call adds one at most. Steps can be lost, but none can be invented.

# %%
predict("the-steps")

# %%
free = fresh(StepCounter, "reentrant_counter", ReentrantCallbackGroup())
spin_with(MultiThreadedExecutor(num_threads=4), free, 2.0)

single = fresh(StepCounter, "exclusive_counter", MutuallyExclusiveCallbackGroup())
spin_with(MultiThreadedExecutor(num_threads=4), single, 2.0)
reveal("the-steps", steps=free.steps, calls=len(free.called))

# %% tags=["nbval-ignore-output"]
print(f"reentrant:          {len(free.called)} calls, {free.steps} steps")
print(f"mutually exclusive: {len(single.called)} calls, {single.steps} steps")

# %% id="race"
print("reentrant: steps were lost:", free.steps < 0.9 * len(free.called))
print("mutually exclusive: steps were lost:", single.steps < len(single.called))

# %% [markdown]
# Both feet read 41, both add one, both write 42. One step is lost. This is a **race**: the result depends on the order
# in which the threads happen to run. There is no error, and a short test may never show it.
#
# Python's own lock, the GIL, does not protect *your* three lines: Python may switch threads between any two of them.
#
# - What shares data goes into **one** mutually exclusive group. There you need no locks.
# - If two groups have to share something, protect it with a lock (`with self.lock:`), or hand it over in a `queue.Queue`.
# - A reentrant group is for callbacks that share nothing.

# %% [markdown]
# ## When it goes wrong
#
# **More threads, and not faster.** A planner that *waits* (for a sensor, for another program) leaves the processor free.
# One that *computes* does not. Four callbacks in four threads, once with waiting and once with computing in Python:


# %%
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


done, used = {}, {}
for job in (wait, compute):
    for threads in (1, 4):
        planner = fresh(Planner, f"{job.__name__}_{threads}", job)
        clock, processor = time.monotonic(), time.process_time()
        if threads == 1:
            spin_with(SingleThreadedExecutor(), planner, 2.0)
        else:
            spin_with(MultiThreadedExecutor(num_threads=threads), planner, 2.0)
        busy, passed = time.process_time() - processor, time.monotonic() - clock
        used[job.__name__, threads] = busy / passed
        done[job.__name__, threads] = len(planner.plans)

# %% tags=["nbval-ignore-output"]
for (name, threads), plans in done.items():
    noun = "threads" if threads > 1 else "thread "
    print(f"{name:<8} {threads} {noun}: {plans:>4} plans in 2 s")

# %% id="computing"
more = done["wait", 4] > 2 * done["wait", 1]
print("waiting: at least twice as many plans with four threads:", more)
for threads in (1, 4):
    busy = "one" if used["compute", threads] < 1.3 else "several"
    noun = "threads" if threads > 1 else "thread"
    print(f"computing: processors kept busy by {threads} {noun}: {busy}")

# %% [markdown]
# Only one thread at a time may run Python code, because of the GIL. Waiting overlaps, computing does not. Computing that
# must not disturb the heartbeat belongs in **another process**. (NumPy and most AI libraries release the GIL while they
# compute. Measure before you choose.)
#
# **The heart beats, and no plan is made.** You can also give slow work to a thread of your own, or to a pool. The callback
# only hands the work over. This program shows what happens when a plan fails:

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
print("the heart beats:", robot.beats > 10)
print("plans asked for:", "several" if robot.asked > 2 else robot.asked)
print("plans made:", robot.planned)
rclpy.try_shutdown()
"""

# %% id="dead-brain"
outcome = run_program(POOL, seconds=40)
print(outcome.log.strip())
print("errors in the log:", outcome.log.count("RuntimeError"))

# %% [markdown]
# No plan, no error, no traceback, and a perfect heartbeat. An exception in a pool is stored in the *future* that
# `submit` returns, and the program never reads it. In a `threading.Thread` you get a traceback, but the thread has ended,
# as in [lesson 08](08_humanoid_status_publisher.ipynb).
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
print("failures logged:", "several" if len(failures) > 2 else len(failures))

# %% [markdown]
# Publish `alive` only while the planner works. A heartbeat proves only that its own timer runs.

# %% [markdown]
# ## From a worked example to your own
#
# **Worked.** A guide robot plans a path on request. Three steps: a group for the slow callback, an executor with two
# threads, and nothing shared but a list that only one side writes to.

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
more = guide.beats > 20
print("more than half of 40 heartbeats, where one thread had time for 16:", more)

# %% [markdown]
# Three requests came at once. Two of them waited in the subscription's queue, and were planned in order. *Mutually
# exclusive* guarantees that.
#
# **Faded.** The same with a queue and a thread of your own. The node now needs only *one* thread for its callbacks, so a
# plain `run` will do. Fill in what is `...`.

# %%
import queue
import threading


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
hint = "none yet: fill in the two places, then run this cell again"
print("paths:", queue_guide.paths or hint)

# %% [markdown]
# **Your own.** In the [exercise](../exercises/10_slow_callbacks.ipynb) the heartbeat of a humanoid stops whenever it
# plans a movement of its arm. Both are watched from outside: the beats, and whether each plan is right.

# %% [markdown]
# ## Check yourself
#
# **1. A callback calls `self.pool.submit(self.plan)`, and `plan` raises an exception. What do you see?**
#
# <details><summary>a) No plan, and no traceback</summary>
#
# ✓ The exception is in the future that `submit` returned. Catch it in `plan`, and log it there.
#
# </details>
# <details><summary>b) <code>spin</code> raises the exception, and the program ends</summary>
#
# ✗ That happens if a callback raises. This callback has only handed the work over.
#
# </details>
# <details><summary>c) A traceback, and no further plan, because the thread of the pool has ended</summary>
#
# ✗ A `threading.Thread` ends like that. A pool keeps the exception, and its thread takes the next task.
#
# </details>
#
# **2. You have one node, and spin it with a `MultiThreadedExecutor` of eight threads. How do its callbacks run?**
#
# <details><summary>a) Those of timers at the same time, those of subscriptions one at a time</summary>
#
# ✗ Groups do not care about the kind of callback.
#
# </details>
# <details><summary>b) Up to eight at the same time</summary>
#
# ✗ They would need permission: groups of their own, or a reentrant one.
#
# </details>
# <details><summary>c) One at a time, as with <code>rclpy.spin</code></summary>
#
# ✓ They are all in the node's default group, which is mutually exclusive.
#
# </details>
#
# **3. Two callbacks in two groups both do `self.steps += 1`. Four threads spin. Is that safe?**
#
# <details><summary>a) Yes, the GIL lets only one thread run Python</summary>
#
# ✗ One at a time, but it may change between the reading and the writing.
#
# </details>
# <details><summary>b) No: put both into one group, or protect the line with a lock</summary>
#
# ✓ Either will do. The group is simpler if the callbacks are short.
#
# </details>
# <details><summary>c) Yes, because both groups are mutually exclusive</summary>
#
# ✗ Each group excludes its own members. The two callbacks are not in the same one.
#
# </details>
#
# **4. `on_goal` (0.8 s) is alone in a mutually exclusive group, and four threads spin. Three goals come. What happens?**
#
# <details><summary>a) They are planned at the same time, by three threads</summary>
#
# ✗ That takes a reentrant group. This group lets one call run at a time, even if it is the same callback.
#
# </details>
# <details><summary>b) The first one is planned, and the other two are lost</summary>
#
# ✗ A group that is busy loses nothing. Messages wait in the queue of their subscription, up to its depth.
#
# </details>
# <details><summary>c) They are planned one after another, in the order in which they came</summary>
#
# ✓ Two of them wait in the subscription's queue. The last plan is ready after about 2.4 s.
#
# </details>

# %% [markdown]
# ## Talk it through
#
# Copy the prompt for an AI assistant, or discuss it with a colleague. State your own view first.
#
# ```text
# I program a robot with ROS 2 Jazzy in Python (rclpy). My robot publishes a heartbeat
# at 10 Hz and listens for goals. Planning takes 0.8 s and sometimes raises an
# exception. Goals may come faster than I can plan. Compare three designs: a callback
# group with a MultiThreadedExecutor, a worker thread with a queue, and a second
# process. What happens in each to the order of goals, to an exception, and to the goals
# that wait? Name only functions that exist in rclpy for Jazzy.
# ```
#
# <details><summary>What a good answer contains</summary>
#
# *Group and threads:* goals wait in the subscription's queue; beyond its depth the oldest are lost. The order is kept as
# long as the group is mutually exclusive. An exception comes out of `spin` and ends the program. *Queue and worker:* the
# queue can be long, so the robot may still be planning for goals that are a minute old. An exception must be handled
# in the worker, or no plan is made any more. *Process:* the heart survives even a crash of the planner, but something
# has to notice and restart it. Good answers ask whether an old goal is worth planning at all: often only the newest
# counts, and a depth of 1 is right. They do not propose a reentrant group, because two plans would share one planner.
#
# </details>
#
# <details><summary>What to check in the reply</summary>
#
# Two claims you may meet. Both are wrong: each was tried with the rclpy of this course.
#
# - **Replace the executor by a `MultiThreadedExecutor`; that is enough:** All callbacks of a node are in one mutually
#   exclusive group unless you say otherwise. They still run one at a time.
# - **The executor logs an exception in a callback and goes on:** In fact, the exception comes out of `spin`. Without
#   an `except` the program ends.
#
# </details>

# %% [markdown]
# ## Take away
#
# - While a callback runs, its thread does nothing else. Timer ticks that are due meanwhile are dropped.
# - A MultiThreadedExecutor alone changes nothing. Slow work needs a callback group of its own **and** a second thread.
# - What shares data belongs in one mutually exclusive group, or behind a lock, or into a queue.
# - Python threads overlap waiting, not computing. Heavy computing belongs in a process of its own.
# - Handle exceptions in the thread that does the work.
#
# **Before:** [09 · The joint positions](09_joint_positions.ipynb)
#
# **Next:** [11 · Polling against callbacks](11_polling_against_callbacks.ipynb): what if you used a loop that polls?
#
# **More:** [Using callback groups](https://docs.ros.org/en/jazzy/How-To-Guides/Using-callback-groups.html) and
# [About executors](https://docs.ros.org/en/jazzy/Concepts/Intermediate/About-Executors.html).
