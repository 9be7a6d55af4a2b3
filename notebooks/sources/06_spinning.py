# %% [markdown]
# # 06 · Spinning
#
# A node can have timers and subscriptions, but none of its callbacks run until the node is spun. So what does spinning
# do, and how do you spin a node without blocking the rest of your program?
#
# - **Minutes:** 50
# - **You need:** lessons [04](04_subscriptions_and_callbacks.ipynb) and [05](05_timers.ipynb): subscriptions, timers,
#   and their callbacks
# - **You will be able to:**
#   - explain the difference between `spin` and `spin_once`
#   - spin a node by hand
#   - choose a timeout
#   - recognize five common spinning mistakes
# - **Not covered:** several threads that share the work (lesson 10), services (lesson 12)

# %% [markdown]
# This robot moves each arm in a timer callback. The next cell does nothing for two seconds, and then calls `spin_once`
# sixty times. Watch the arms.

# %%
import time

import rclpy

from lesson_nodes.two_arms import LEFT_SHOULDER, TwoArms
from workbook.lesson import about, fresh, init
from workbook.pictures import humanoid
from workbook.pictures.live import LiveFigure

init()
arms = fresh(TwoArms)
figure_of_it = LiveFigure("a humanoid robot that moves its arms while it is spun")

seen = [arms.angles[LEFT_SHOULDER]]
figure_of_it.show(humanoid.draw(arms.angles))
time.sleep(2.0)
seen.append(arms.angles[LEFT_SHOULDER])
print(f"in two seconds without a call: moved by {max(seen) - min(seen):.1f} rad")

for _ in range(60):
    rclpy.spin_once(arms, timeout_sec=0.1)
    figure_of_it.show(humanoid.draw(arms.angles))
    seen.append(arms.angles[LEFT_SHOULDER])
moved_rad = about(max(seen) - min(seen), "rad", between=(1.0, 2.1))
print("in sixty calls: moved by", moved_rad)

# %% [markdown]
# The numbers show how far the left shoulder turned. The arm moved only because you called `spin_once`. In a real
# program, `rclpy.spin` makes these calls for you.
#
# [the same without helpers: init, fresh]

# %% [markdown] prediction="five-words"
# ## Predict
#
# A robot subscribes to `/robot/words`. Five words have arrived and are waiting in the subscription's queue. Then this
# line runs once:
#
# ```python
# rclpy.spin_once(robot, timeout_sec=0.5)
# ```
#
# How many times does the robot's callback run?
#
# - **a** 1.
#   when `heard == 1`
#   ✓ One call to `spin_once` runs one callback, and each word needs its own call. Four words are still waiting.
# - **b** 5: one spin handles everything that has arrived.
#   when `heard == 5`
#   ✗ `spin_once` runs one callback and returns. Each waiting word needs its own call.
# - **c** As many times as it can in half a second.
#   when `1 < heard < 5`
#   ✗ The timeout doesn't limit how long callbacks run. It limits how long the call waits when nothing is ready.
# - **d** 0: the callback ran by itself as each word arrived, so nothing is left to do.
#   when `heard == 0`
#   ✗ Words arrive by themselves, but the callback runs in your thread, and only while that thread spins the node.

# %%
from workbook.lesson import predict, reveal

predict("five-words")

# %% [markdown]
# ## Run it
#
# The robot's code is in [lesson_nodes/attentive_robot.py](../lesson_nodes/attentive_robot.py). One timer makes the
# robot's heart beat, and another makes the robot look around. The robot also repeats each word that it receives. Each
# callback appends to the list `robot.done`. For now, both timers are so slow that only the words matter.
#
# First, we publish words without spinning the robot.

# %% id="forgotten-spin"
from rclpy.node import Node
from std_msgs.msg import String

from lesson_nodes.attentive_robot import AttentiveRobot

mouth = fresh(Node, "mouth").create_publisher(String, "/robot/words", 10)


def slow_robot():
    """A robot whose timers tick once every 1000 s."""
    robot = AttentiveRobot()
    for timer in robot.timers:
        timer.timer_period_ns = 1000 * 10**9
        timer.reset()
    return robot


def say(*words):
    """Say words to the robot, once it listens, and let them arrive."""
    end = time.monotonic() + 10.0
    while mouth.get_subscription_count() == 0:
        if time.monotonic() > end:
            raise TimeoutError("no subscription on /robot/words")
        time.sleep(0.01)
    for word in words:
        mouth.publish(String(data=word))
    time.sleep(0.2)


robot = fresh(slow_robot)
say("stop", "wait", "turn", "wave", "walk")
time.sleep(1.0)
print("heard after more than a second:", robot.done)

# %% [markdown]
# The list is empty: publishing doesn't need `spin`, but callbacks do. Next comes the call from the prediction.

# %% id="one-is-not-all"
rclpy.spin_once(robot, timeout_sec=0.5)
print("after one spin_once:", robot.done)
reveal("five-words", heard=len(robot.done))

# %% id="your-calls"
from workbook.lesson import yours

calls = ...  # TODO: how many more calls does it take to handle all other words?

for _ in range(0 if calls is ... else calls):
    rclpy.spin_once(robot, timeout_sec=0.5)
yours(
    ... if calls is ... else robot.done,
    ["heard stop", "heard wait", "heard turn", "heard wave", "heard walk"],
    "One call runs one callback, and one callback handles one word.",
)

# %% [markdown]
# ## Look inside
#
# Before the first call, nothing was spinning the robot, so no callback ran. There was no error or warning, either.
# That's what a **forgotten spin** looks like.
#
# An arriving message doesn't call your callback: a DDS thread just puts the message into the subscription's queue. A
# timer doesn't call your callback, either: it only determines when the callback is due. Only the **executor** runs
# callbacks. `rclpy.spin_once(node)` adds the node to an executor for one iteration:
#
# 1. The executor checks whether anything is ready: a message in a queue, or a timer that's due. If not, it waits.
# 2. It takes **one** ready message or timer and runs its callback, in the thread that called `spin_once`.
# 3. `spin_once` returns `None`, whether or not a callback ran.
#
# `rclpy.spin(node)` repeats these three steps. So spinning happens in *your* thread, not in the background.
#
# Next, the timers run at normal speed: the heart beats every 1.0 s, and the robot looks around every 2.1 s. We publish
# three words, reset both timers, and wait 2.2 s without spinning. By then, both timers are due and three words are
# waiting. We call `spin_once` eight times, and record which callback each call runs and how long the call takes.

# %%
from workbook.lesson import show_machine, watch_machine

robot = fresh(AttentiveRobot)
calls = []
with watch_machine(robot) as seen:
    say("stop", "wait", "turn")
    for timer in robot.timers:
        timer.reset()
    time.sleep(2.2)

    for call in range(1, 9):
        before, began = len(robot.done), time.monotonic()
        rclpy.spin_once(robot, timeout_sec=2.0)
        calls.append((call, robot.done[before:], time.monotonic() - began))

for call, ran, _ in calls:
    print(f"call {call}: {len(ran)} callback: {', '.join(ran)}")
took = [seconds for _, _, seconds in calls]
print("all of calls 1 to 5 took", about(sum(took[:5]), "s", between=(0, 0.5)))
print("all of calls 6 to 8 took", about(sum(took[5:]), "s", between=(0.5, 3)))

# %% [markdown]
# Here are the eight calls, drawn as in lesson 04. Each green arrow is one call.

# %% id="machine"
show_machine(
    seen,
    "three words and one tick of each timer wait while nobody spins; then five calls "
    "run five callbacks at once, timers before words; three more wait for the timers",
)

# %% [markdown]
# Calls 1 and 2 run the timers' callbacks. Calls 3 to 5 handle the words in order of arrival. After that, nothing else
# is ready, so `spin_once` *waits* and returns soon after the next timer is due.
#
# In this rclpy version, timers come before messages, but don't rely on that order. The heartbeat was due at 1.0 s
# *and* at 2.0 s, but its callback ran only once. [Lesson 05](05_timers.ipynb) explains why.
#
# | executor | how it runs callbacks |
# |---|---|
# | `SingleThreadedExecutor` | one thread, one callback at a time; `rclpy.spin` uses it |
# | `MultiThreadedExecutor` | several threads (lesson 10) |
# | `EventsExecutor` (`rclpy.experimental`) | in our tests of this build, its `spin` ran no callbacks; don't use it here |

# %% [markdown]
# ## Change it
#
# Each example below runs as a separate program. If a program prints nothing for four seconds, a **watchdog** terminates
# it. The examples are functions in [lesson_nodes/ways_to_spin.py](../lesson_nodes/ways_to_spin.py). `try_out` prints
# one function's code, runs it with a new node, and reports how the program ended.

# %%
import inspect

from lesson_nodes import ways_to_spin
from workbook.lesson import run_program


def try_out(way, *numbers, interrupt_at=None, show_code=True):
    """Show a function, run it as a program; print its words and how it ended."""
    if show_code:
        print(inspect.getsource(way))
    seen = run_program(
        ways_to_spin,
        arguments=[way.__name__, *map(str, numbers)],
        silence=4.0,
        interrupt_at=interrupt_at,
    )
    for line in seen.log.splitlines():
        if line.strip() and not line.startswith((" ", "Traceback")):
            print("  |", line)
    if seen.ended_by == "judge":
        print("the watchdog had to end it")
    else:
        print(
            "it ended with",
            f"signal {seen.signal}" if seen.signal else f"exit code {seen.exit}",
        )
    return seen


_ = try_out(ways_to_spin.with_timeout, 0.5)

# %% [markdown] prediction="no-timeout"
# ### Experiment 1: no timeout
#
# `node` has no timer and no subscription. What does `rclpy.spin_once(node)` do without a `timeout_sec`?
#
# - **a** It finds that nothing is ready, and returns right away.
#   ✗ With `timeout_sec=0`, it would do that. Without the argument, it waits until something is ready.
# - **b** It never returns.
#   when `not came_back`
#   ✓ Without a timeout, it waits until something is ready. In this node, nothing can ever become ready.
# - **c** It waits for a second, the default timeout, and then returns.
#   when `came_back`
#   ✗ There's no default of one second. The default is `timeout_sec=None`, which means: wait without a limit.

# %%
predict("no-timeout")

# %% id="no-timeout"
seen = try_out(ways_to_spin.no_timeout)
reveal("no-timeout", came_back="after" in seen.log)

# %% [markdown]
# The "once" in `spin_once` means *one callback*. With a timeout, `spin_once` waits until something is ready or the
# timeout expires. Without one, it waits until something is ready, which never happens in this node. If the node had a
# timer, you wouldn't notice this mistake, because each tick would end the call.
#
# In a notebook, a test, or any program with other work to do, **always pass `timeout_sec`**.

# %% [markdown] prediction="timeout-zero"
# ### Experiment 2: a timeout of 0
#
# If waiting is dangerous, why wait at all? With `timeout_sec=0`, the call only polls and returns right away. Three
# loops, with timeouts of 0, 0.01, and 0.1 s, each spin a node until its 10 Hz timer has ticked twenty times. What do
# you expect from the first loop?
#
# - **a** It takes as long as the others, but it keeps a CPU core busy the whole time.
#   when `soonest_s > 1.9 and times_as_many_calls > 5`
#   ✓ Each loop needs twenty ticks, and the timer sets their pace. Between ticks, the first loop never sleeps.
# - **b** It takes as long as the others and uses hardly any more CPU time, because polling costs nothing.
#   when `soonest_s > 1.9 and times_as_many_calls <= 5`
#   ✗ Each call asks the middleware which callbacks are ready. One call is cheap, but thousands per second aren't.
# - **c** It reaches twenty ticks before the others, because it polls more often.
#   when `soonest_s <= 1.9`
#   ✗ The timer decides when a tick is due. Polling more often doesn't make a tick due earlier.

# %%
predict("timeout-zero")

# %% id="busy-loop"
print(inspect.getsource(ways_to_spin.twenty_ticks))

meters = {}
for timeout_s in (0, 0.01, 0.1):
    seen = run_program(ways_to_spin, arguments=["twenty_ticks", str(timeout_s)])
    meters[timeout_s] = tuple(map(float, seen.log.split()[-3:]))

USUAL = {0: (500, 1_000_000), 0.01: (40, 700), 0.1: (20, 100)}
for timeout_s, (iterations, took_s, _) in meters.items():
    count = about(iterations, "iterations", between=USUAL[timeout_s])
    seconds = about(took_s, "s", between=(1.9, 8))
    print(f"timeout_sec={timeout_s}: {count} in {seconds}")
soonest = min(took_s for _, took_s, _ in meters.values())
times_as_many = meters[0][0] / meters[0.1][0]
reveal("timeout-zero", soonest_s=soonest, times_as_many_calls=times_as_many)

# %%
from workbook.pictures.figures import figure, show
from workbook.pictures.palette import GREEN, RED

fig, axes = figure(6.4, 2.4)
for row, (iterations, took_s, busy_s) in enumerate(meters.values()):
    share = busy_s / took_s
    axes.barh(row, 100 * share, color=GREEN if row else RED, height=0.55)
    axes.annotate(
        f" {iterations:,.0f} iterations", (100 * share, row), va="center", fontsize=9
    )
names = [f"timeout_sec={timeout_s}" for timeout_s in meters]
axes.set(
    yticks=range(3),
    yticklabels=names,
    xlabel="time in which the loop doesn't sleep (%)",
    xlim=(0, 135),
)
axes.set_xticks(range(0, 101, 25))
axes.set_title("With a timeout of 0, the loop never sleeps")
axes.grid(False)
axes.invert_yaxis()
show(
    fig,
    "the loop with timeout 0 is busy nearly all the time, for thousands of iterations; "
    "the others sleep most of the time",
)

# %% [markdown]
# A loop that only polls is called a **busy loop**. It keeps a CPU core busy, and on a robot, that drains the battery. A
# longer timeout doesn't delay anything, because the wait ends as soon as a callback becomes ready. So a timeout isn't a
# period. It's the maximum time that the call waits if nothing happens.

# %% [markdown] prediction="after-spin"
# ### Experiment 3: the code after `spin`
#
# A robot patrols its route once and must then park its arm. When the patrol is over, one of the node's timers calls
# this function:
#
# ```python
# def finish() -> None:
#     print("round finished")
#     rclpy.shutdown()
# ```
#
# The program ends with these two lines. No one presses Ctrl-C.
#
# ```python
# rclpy.spin(node)
# print("arm parked")
# ```
#
# Does the arm get parked?
#
# - **a** Yes, but too early: `spin` starts the node in the background, and the program continues.
#   when `0 <= parked_at < finished_at`
#   ✗ `spin` runs the callbacks in this thread. The next line has to wait until `spin` returns.
# - **b** No: `spin` raises an exception, because the context is shut down.
#   when `parked_at < 0 and ended_by_itself`
#   ✗ `spin` raises one if the shutdown happens during a wait. Here, the shutdown happens in a callback, between two
#   waits.
# - **c** Yes: when the patrol is over, `spin` returns.
#   when `0 <= finished_at < parked_at`
#   ✓ After each callback, `spin` checks whether the context is still valid. Now it isn't, so `spin` returns.
# - **d** No: `spin` never returns, so the program hangs.
#   when `parked_at < 0 and not ended_by_itself`
#   ✗ `spin` continues only as long as the context is valid, and checks that after each callback.

# %%
predict("after-spin")

# %% id="one-round"
seen = try_out(ways_to_spin.park_after_round)
reveal(
    "after-spin",
    finished_at=seen.log.find("round finished"),
    parked_at=seen.log.find("arm parked"),
    ended_by_itself=seen.ended_by != "judge",
)

# %% [markdown]
# In essence, `rclpy.spin(node)` is this loop:
#
# ```python
# while rclpy.ok():
#     executor.spin_once()
# ```
#
# `rclpy.shutdown()` makes `rclpy.ok()` return `False`, so the loop ends. Ctrl-C is different: it makes `spin` raise
# `KeyboardInterrupt` ([lesson 01](01_the_context.ipynb)). Then the line after `spin` is skipped, so code that must run
# at the end belongs in `finally`. The next cell runs the program without `finally` and with it:

# %% id="after-spin"
_ = try_out(ways_to_spin.park_after_spin, interrupt_at="tick")
print()
_ = try_out(ways_to_spin.park_in_finally, interrupt_at="tick")

# %% [markdown]
# ## When it goes wrong
#
# **Spinning inside a callback.** A planner needs a map and waits for it in a callback. Another callback of the same
# node is supposed to deliver the map after 0.3 s.

# %% id="spin-in-callback"
_ = try_out(ways_to_spin.wait_in_callback)

# %% [markdown]
# A **future** is a placeholder for a result that isn't there yet. `spin_until_future_complete(node, future)` spins the
# node until the future has its result. But this node runs only one callback at a time. While `plan` is running, the
# callback that delivers the map can't run. Without the timeout, this program would hang silently.
#
# The fix: don't wait. Register a function that runs *when* the map arrives, and then return from the callback:

# %%
_ = try_out(ways_to_spin.go_on_later)

# %% [markdown]
# Outside callbacks, `spin_until_future_complete` is useful: see the last lines of `go_on_later`.
#
# **Your turn.** Write a function for the future to call when the map arrives. The function receives the future and
# appends the map to `plans`.

# %% id="your-done-callback"
from rclpy.task import Future

map_is_there, plans = Future(), []

on_map = ...  # TODO: a function

if on_map is not ...:
    map_is_there.add_done_callback(on_map)
map_is_there.set_result("a map")
hint = "lambda future: plans.append(future.result())"
yours(... if on_map is ... else plans, ["a map"], hint)

# %% [markdown]
# **A rate without a spin.** Programmers coming from ROS 1 often write this loop:

# %% id="rate-on-main-thread"
_ = try_out(ways_to_spin.rate_without_spin)

# %% [markdown]
# The loop prints `step` once and then hangs. `rate.sleep()` waits for one of the node's timers. But timers fire only
# while a thread spins the node, and the only thread is asleep. Instead, use a timer with a callback, as in lesson 05.
#
# **Two threads that call `rclpy.spin`.** The robot has two arms, each with its own node. Does each node need its own
# thread?

# %% id="two-spins"
_ = try_out(ways_to_spin.two_spins)

# %% [markdown]
# `generator already executing` means that two threads are using the same executor. If you don't pass an executor,
# `rclpy.spin` uses the **global executor**, which threads can't share. The second thread ends with this error, so its
# node isn't spun anymore.
#
# One executor can spin many nodes, so one thread is enough:

# %%
_ = try_out(ways_to_spin.one_executor)

# %% [markdown]
# **A thread left behind.** Often, one thread spins the node while the main thread does other work. How does such a
# program end?

# %% id="thread-at-exit" tags=["nbval-ignore-output"]
left_behind = try_out(ways_to_spin.thread_left_behind)

# %%
print("first:", left_behind.log.splitlines()[0])
print("then:", "a crash" if left_behind.signal else f"exit code {left_behind.exit}")

# %% [markdown]
# The program finishes its work, but then it *aborts*: at exit, Python stops the thread in the middle of C++ code. You
# see `terminate called without an active exception` or another error. A supervisor such as systemd logs a crash each
# time the program stops.
#
# Code that starts a thread must also end it. First, shut down the executor, so that `spin` returns. Then wait for the
# thread to finish. (On a busy machine, rclpy may print a harmless `AttributeError`.)

# %% tags=["nbval-ignore-output"]
_ = try_out(ways_to_spin.thread_ended)

# %% [markdown]
# **A timer that is always ready.** A timer is due every 10 ms, but its callback takes 20 ms. Five messages are waiting.
# We spin the node twice, for two seconds each time. In the first run, each call's timeout is the time that's left; in
# the second, it's a constant 50 ms.

# %% id="unfair-turns"
print("timeout_sec=left")
_ = try_out(ways_to_spin.busy_timer, 0)
print("\ntimeout_sec=0.05")
_ = try_out(ways_to_spin.busy_timer, 0.05, show_code=False)

# %% [markdown]
# When several callbacks are ready, the executor normally runs all of them, one per call, before it looks for newly
# ready ones. But if a call's timeout *differs* from the previous call's timeout, the executor starts over with the
# first timer. With `left` as the timeout, it starts over on every call, so the messages are never handled. Use the same
# timeout in each iteration. (A callback that takes longer than its timer's period is a bug, too: see lesson 10.)

# %% [markdown]
# ## From a worked example to your own
#
# **Worked example.** We want to wait until the robot receives a word, but for at most two seconds. A safe loop has
# three parts: a condition that ends it, a time limit, and short waits with the *same* timeout. Each wait lasts at most
# 0.1 s, and `min(left, 0.1)` shortens only the last one, so that the loop ends on time. Compute `left` only once per
# iteration, and return if it's zero or less. Otherwise, `spin_once` might get a *negative* timeout, and then it would
# wait forever.


# %%
def wait_until(node, is_so, seconds):
    """Spin until `is_so()` holds. Returns whether it did within `seconds` s."""
    end = time.monotonic() + seconds
    while not is_so():
        left = end - time.monotonic()
        if left <= 0:
            return False
        rclpy.spin_once(node, timeout_sec=min(left, 0.1))
    return True


robot = fresh(slow_robot)
wait_until(robot, lambda: robot.done, 0.5)
print("after half a second of silence:", robot.done)
say("stop", "wait")
wait_until(robot, lambda: robot.done, 2.0)
print("after two words:", robot.done)

# %% [markdown]
# The function returned after the first word, because one word met the condition. The second word is still in the queue.
#
# **Fill in the blank.** Now wait for all three words.

# %%
all_three = ...  # TODO: a function without arguments: has the robot done three things?

robot = fresh(slow_robot)
say("turn", "wave", "walk")
if all_three is not ...:
    wait_until(robot, all_three, 2.0)
yours(
    ... if all_three is ... else robot.done,
    ["heard turn", "heard wave", "heard walk"],
    "lambda: len(robot.done) == 3",
)

# %% [markdown]
# **Your own.** In the [exercise](../exercises/06_spinning.ipynb), you write a function that spins a node for a given
# number of seconds and then returns. The judge runs it with several robots. One has timers and slow callbacks, and
# receives a burst of words. Another has no timers.

# %% [markdown]
# ## Check yourself
#
# **1. Ten messages are waiting, and two timers are due. How many `spin_once` calls does it take to handle them all?**
#
# <details><summary>a) One</summary>
#
# ✗ One call runs one callback. You saw that five words needed five calls.
#
# </details>
# <details><summary>b) Three: one for each timer, one for the queue</summary>
#
# ✗ One call doesn't handle a whole queue. Each message needs its own call.
#
# </details>
# <details><summary>c) Twelve</summary>
#
# ✓ Ten messages and two ticks make twelve callbacks. It takes more calls if a timer becomes due again in between.
#
# </details>
#
# **2. A loop calls `spin_once(node, timeout_sec=0.5)`. A message arrives during the wait. When is the message handled?**
#
# <details><summary>a) Right away</summary>
#
# ✓ The message ends the wait. The timeout matters only if nothing becomes ready.
#
# </details>
# <details><summary>b) At the end of the half second</summary>
#
# ✗ That would be polling. Here, the wait ends as soon as the message is ready.
#
# </details>
# <details><summary>c) Never: the call was waiting for something else</summary>
#
# ✗ The call waits for whichever comes first: a message, a timer, or the end of the timeout.
#
# </details>
#
# **3. Which of these lines is the worst idea in a timer callback?**
#
# <details><summary>a) <code>self.publisher.publish(message)</code></summary>
#
# ✗ Most timers exist to publish something, and `publish` doesn't wait for other callbacks.
#
# </details>
# <details><summary>b) <code>rclpy.spin_until_future_complete(self, future)</code></summary>
#
# ✓ It waits for another callback of this node, which can't run until this callback returns. Without a timeout, it waits
# forever.
#
# </details>
# <details><summary>c) <code>future.add_done_callback(self.on_result)</code></summary>
#
# ✗ This line is the fix: it registers the code to run later, and returns.
#
# </details>
#
# **4. A thread in your program runs `executor.spin()`. When the work is done, how should the program end?**
#
# <details><summary>a) It needs no extra code: a daemon thread ends with the program</summary>
#
# ✗ Python stops the thread in the middle of C++ code, so the program may abort.
#
# </details>
# <details><summary>b) With <code>thread.join()</code>, and then <code>executor.shutdown()</code></summary>
#
# ✗ `join` waits until `spin` returns. But `shutdown`, which would make it return, comes only after `join`.
#
# </details>
# <details><summary>c) With <code>executor.shutdown()</code>, and then <code>thread.join()</code></summary>
#
# ✓ The first call makes `spin` return. The second one waits until the thread has ended.
#
# </details>

# %% [markdown]
# ## Talk it through
#
# Read this prompt and write down your own answer. Then give the prompt to an AI assistant, or discuss it with a
# colleague.
#
# ```text
# I'm programming a robot with ROS 2 Jazzy in Python (rclpy). My program reads a joystick
# in a loop (`while True: read, publish, sleep 20 ms`) and must also react to
# `/emergency_stop`. Where should I spin the node? Compare at least three ways. Make sure
# that every rclpy function you use exists in Jazzy.
# ```
#
# <details><summary>What a good answer covers</summary>
#
# The loop never spins the node, so the emergency stop would wait in its queue forever. There are three solutions:
#
# 1. Turn the loop into a timer with a period of 20 ms, and call `rclpy.spin`. This is the usual solution, but it works
#    only if reading the joystick never blocks.
# 2. Keep the loop, but instead of sleeping, spin until the 20 ms have passed. Call `spin_once` repeatedly with a short
#    timeout, because one call runs only one callback. Then the emergency stop waits for at most one other callback.
#    With `timeout_sec=0` instead of the sleep, the loop would keep a CPU core busy.
# 3. Spin in a separate thread with its own executor, and end the thread with `shutdown` and `join`. This is the right
#    solution if the library that reads the joystick blocks. But now two threads access the same data.
#
# A good answer also asks how quickly the robot must stop, and whether an emergency stop should depend on a single
# Python loop at all.
#
# </details>
#
# <details><summary>What to check in the reply</summary>
#
# Watch for these two mistakes. We checked both with the rclpy version that this course uses.
#
# - **`rclpy.spin_some(node)`:** This function belongs to rclcpp, the C++ library. rclpy has `spin_once`.
# - **`spin_once(node, timeout_sec=0)` handles everything that's waiting:** In fact, it runs one callback. Five waiting
#   messages need five calls.
#
# </details>

# %% [markdown]
# ## Take away
#
# - Callbacks run only while a thread spins the node, and they run in that thread.
# - `spin_once` runs at most one callback and returns `None`. `spin` does this over and over until the context is shut
#   down.
# - Pass the same short timeout to every `spin_once`. With no timeout or a negative one, the call can block forever; in
#   a loop, a timeout of 0 keeps a CPU core busy.
# - Don't spin or sleep inside a callback. Return, and let another callback continue the work.
# - One executor can spin many nodes. If you spin in a thread, shut down the executor and then join the thread.
#
# **Before:** [05 · Timers](05_timers.ipynb)
#
# **Next:** [07 · Typed nodes](07_typed_nodes.ipynb), where a type checker reads your node before it runs.
#
# **More:** [About executors](https://docs.ros.org/en/jazzy/Concepts/Intermediate/About-Executors.html), and the
# [rclpy](https://docs.ros.org/en/jazzy/p/rclpy) reference for the functions that you called.
