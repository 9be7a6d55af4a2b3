# %% [markdown]
# # 06 · Spinning
#
# A node that is not spun has timers and subscriptions, and does nothing. Spinning lets its callbacks run.
#
# - **Minutes:** 50
# - **You need:** lessons [04](04_subscriptions_and_callbacks.ipynb) and [05](05_timers.ipynb): what a subscription and
#   a timer call
# - **You will be able to:**
#   - say what `spin` and `spin_once` do
#   - spin a node by hand
#   - choose a timeout
#   - recognize five mistakes with spinning
# - **Left out:** several threads that share the work (lesson 10), services (lesson 12)

# %% [markdown]
# Both arms of this robot have timers. For two seconds we do nothing. Then we call `spin_once` sixty times. Watch the arms.

# %%
import time

import rclpy

from lesson_nodes.two_arms import TwoArms
from workbook.lesson import fresh, init
from workbook.pictures import humanoid
from workbook.pictures.live import LiveFigure

init()  # rclpy.init(), made so that a cell can be run again
arms = fresh(TwoArms)
figure_of_it = LiveFigure("a humanoid robot that moves its arms while it is spun")

at_first = list(arms.angles)
figure_of_it.show(humanoid.draw(arms.angles))
time.sleep(2.0)
print("moved while no one called spin_once:", list(arms.angles) != at_first)

for _ in range(60):
    rclpy.spin_once(arms, timeout_sec=0.1)
    figure_of_it.show(humanoid.draw(arms.angles))
print("moved while we did:             ", list(arms.angles) != at_first)

# %% [markdown]
# Your calls drove this robot. In a real program `rclpy.spin` does that. This lesson is about what happens in one
# iteration, one `spin_once`.

# %% [markdown] prediction="five-words"
# ## Predict
#
# A robot subscribes to `/robot/words`. Five words were published. They have arrived, and wait in the robot's queue. Then
# this line runs, once:
#
# ```python
# rclpy.spin_once(robot, timeout_sec=0.5)
# ```
#
# How many words has the robot heard, that is, how often has its callback run?
#
# - **a** 1.
#   when `heard == 1`
#   ✓ One call of `spin_once` runs one callback, and each word needs a call of its own. Four words still wait.
# - **b** 5: one spin handles all that has come.
#   when `heard == 5`
#   ✗ `spin_once` runs one callback and returns. Each word that waits needs a call of its own.
# - **c** As many as fit into half a second.
#   when `1 < heard < 5`
#   ✗ The timeout is not working time. It is the longest time that the call waits when nothing is ready.
# - **d** 0: the callback ran by itself when each word came, so nothing is left to do.
#   when `heard == 0`
#   ✗ Words arrive by themselves, but the callback runs in your thread, and only while that thread spins.

# %%
from workbook.lesson import predict, reveal

predict("five-words")

# %% [markdown]
# ## Run it
#
# The robot is in [lesson_nodes/attentive_robot.py](../lesson_nodes/attentive_robot.py). Its heart beats, it looks
# around, and it repeats each word that it hears. It keeps all that in a list, `robot.done`. For now both timers
# are so slow that only the words matter.
#
# First we publish, and do not spin at all.

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
# Publishing worked, because `publish` needs no spin. Now the one call in question.

# %% id="one-is-not-all"
rclpy.spin_once(robot, timeout_sec=0.5)
print("after one spin_once:", robot.done)
reveal("five-words", heard=len(robot.done))

# %%
for call in range(4):
    rclpy.spin_once(robot, timeout_sec=0.5)
    print(f"after {call + 2}:", robot.done)

# %% [markdown]
# ## Look inside
#
# Before the first call, nothing spun the robot: no callback, no error, no warning. That is what a **forgotten spin**
# looks like.
#
# A message that arrives does not call your callback. DDS puts it into the subscription's queue, in a thread of its own. A
# timer does not call your callback either: it only knows when it is due. Both wait for the **executor**.
# `rclpy.spin_once(node)` gives the node to an executor for one iteration:
#
# 1. Is something ready: a message in a queue, a timer that is due? If not, wait.
# 2. Take **one** ready thing and run its callback, in the thread that called `spin_once`.
# 3. Return `None`, whether a callback ran or not.
#
# `rclpy.spin(node)` calls `spin_once` again and again. So spinning happens in *your* thread, and not in the background.
#
# Now with timers. The heart beats every 1.0 s, the robot looks around every 2.1 s, and three words are published. Both
# timers start anew (`reset`), and we wait 2.2 s without spinning. Then both timers are due and three words wait. We call
# `spin_once` eight times, and note what ran in each call and how long it waited.

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

# %% [markdown]
# The machine of lesson 04 shows the same eight calls. Each green arrow is one call of `spin_once`.

# %% id="machine"
show_machine(
    seen,
    "three words and one tick of each timer wait while nobody spins; then five calls "
    "run five callbacks at once, timers before words; three more wait for the timers",
)

# %%
waits = [waited for _, _, waited in calls]
print("each call ran one callback:", all(len(ran) == 1 for _, ran, _ in calls))
print(
    "the last three waited longer than the first five:", sum(waits[5:]) > sum(waits[:5])
)

# %% [markdown]
# Calls 1 and 2 run the timers' callbacks, calls 3 to 5 the words, in the order in which they came. From call 6 on nothing is
# ready, so `spin_once` *waits*, and returns soon after the next timer is due.
#
# In this version timers come before messages. Do not rely on that. Note what is missing: the heart was due at 1.0 s
# *and* at 2.0 s, and beat once. You know why from [lesson 05](05_timers.ipynb).
#
# | executor | what it does |
# |---|---|
# | `SingleThreadedExecutor` | one thread, one callback at a time. `rclpy.spin` uses it |
# | `MultiThreadedExecutor` | several threads (lesson 10) |
# | `EventsExecutor` (`rclpy.experimental`) | never called a timer or a subscription in this build, when we tried it: do not use it here |

# %% [markdown]
# ## Change it
#
# Each piece of code below runs as a program of its own. A **watchdog** ends a program that has printed nothing for four
# seconds. The pieces are the functions of
# [lesson_nodes/ways_to_spin.py](../lesson_nodes/ways_to_spin.py). `try_out` shows one of them, runs it with a new node, and
# says how it ended.

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
    if seen.ended_by == "bench":
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
# `node` has no timer and no subscription. What does `rclpy.spin_once(node)` do, without a `timeout_sec`?
#
# - **a** It sees that nothing is ready, and comes back at once.
#   ✗ That is what it does with `timeout_sec=0`. Without the argument it waits for something to do.
# - **b** It does not come back.
#   when `not came_back`
#   ✓ Without a timeout it waits until something is ready. This node has nothing that ever will be.
# - **c** It waits for a second, the default timeout, and comes back.
#   when `came_back`
#   ✗ There is no default of one second. `timeout_sec=None` is the default, and means: wait without a limit.

# %%
predict("no-timeout")

# %% id="no-timeout"
seen = try_out(ways_to_spin.no_timeout)
reveal("no-timeout", came_back="after" in seen.log)

# %% [markdown]
# "once" means *one callback*. With a timeout, `spin_once` waits until something is ready, or until the timeout is over.
# Without one, it waits as long as it takes. Here nothing will ever be ready, so it never returns. As long as a node has a
# timer, you do not notice this fault.
#
# In a notebook, in a test, in every program with other work to do: **always give `timeout_sec`**.

# %% [markdown] prediction="timeout-zero"
# ### Experiment 2: a timeout of 0
#
# If waiting is dangerous, why wait at all? With `timeout_sec=0` the call only polls, and returns at once. Three loops serve the same 10 Hz timer until it has ticked twenty times, with timeouts of 0, 0.01 and 0.1 s. What do you
# expect of the first?
#
# - **a** It takes as long as the others, and keeps a processor busy all the time.
#   when `soonest_s > 1.9 and times_as_many_calls > 5`
#   ✓ The ticks come when they are due, so it takes as long as the others. In between, the loop never sleeps.
# - **b** It takes as long as the others, and hardly more work: polling costs nothing.
#   when `soonest_s > 1.9 and times_as_many_calls <= 5`
#   ✗ Each call asks the middleware what is ready. One call is cheap, many thousands a second are not.
# - **c** It has its twenty ticks before the others, because it polls more often.
#   when `soonest_s <= 1.9`
#   ✗ The timer decides when a tick is due. Polling more often does not make it due earlier.

# %%
predict("timeout-zero")

# %%
print(inspect.getsource(ways_to_spin.twenty_ticks))

meters = {}
for timeout_s in (0, 0.01, 0.1):
    seen = run_program(ways_to_spin, arguments=["twenty_ticks", str(timeout_s)])
    meters[timeout_s] = tuple(map(float, seen.log.split()[-3:]))

soonest = min(took_s for _, took_s, _ in meters.values())
rounds = {timeout_s: iterations for timeout_s, (iterations, _, _) in meters.items()}
reveal("timeout-zero", soonest_s=soonest, times_as_many_calls=rounds[0] / rounds[0.1])

# %% id="busy-loop"
print("no loop had twenty ticks before two seconds were over:", soonest > 1.9)
print(
    "timeout 0 went round more than 5 times as often as 0.1 s:",
    rounds[0] > 5 * rounds[0.1],
)

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
    xlabel="share of one processor (%)",
    xlim=(0, 135),
)
axes.set_xticks(range(0, 101, 25))
axes.set_title("a timeout of 0 keeps a processor busy")
axes.grid(False)
axes.invert_yaxis()
show(
    fig,
    "the loop with timeout 0 takes most of a processor for thousands of iterations, "
    "the others hardly anything",
)

# %% [markdown]
# This is called a **busy loop**. On a robot it empties the battery. A longer timeout makes nothing slower: a callback that
# becomes ready ends the wait at once. A timeout is the longest you are willing to wait when nothing happens. It is not a
# period.

# %% [markdown] prediction="after-spin"
# ### Experiment 3: what comes after `spin`
#
# A robot makes one round, and must park its arm at the end. When the round is over, a timer of the node calls this:
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
# Is the arm parked?
#
# - **a** Yes, but too early: `spin` starts the node in the background, and the program goes on.
#   when `0 <= parked_at < finished_at`
#   ✗ `spin` runs the callbacks in this thread. The next line has to wait until `spin` is over.
# - **b** No: `spin` raises an exception, because the context is shut down.
#   when `parked_at < 0 and ended_by_itself`
#   ✗ `spin` raises one if the shutdown comes while it waits. A callback runs between two waits.
# - **c** Yes, when the round is over: `spin` returns.
#   when `0 <= finished_at < parked_at`
#   ✓ After each callback, `spin` asks whether the context is still up. It is not, so `spin` returns.
# - **d** No: `spin` never returns, so the program hangs.
#   when `parked_at < 0 and not ended_by_itself`
#   ✗ `spin` works only as long as the context is up. It asks again after each callback.

# %%
predict("after-spin")

# %% id="one-round"
seen = try_out(ways_to_spin.park_after_round)
reveal(
    "after-spin",
    finished_at=seen.log.find("round finished"),
    parked_at=seen.log.find("arm parked"),
    ended_by_itself=seen.ended_by != "bench",
)

# %% [markdown]
# `rclpy.spin(node)` is in essence:
#
# ```python
# while rclpy.ok():
#     executor.spin_once()
# ```
#
# Ctrl-C is another case. You know from [lesson 01](01_the_context.ipynb) that on Ctrl-C, `spin` raises
# `KeyboardInterrupt`. The line after `spin` is skipped. So what must be done at the end belongs in `finally`. Here is the
# program without `finally`, and then with it:

# %% id="after-spin"
seen = try_out(ways_to_spin.park_after_spin, interrupt_at="tick")
print("the arm was parked:", "arm parked" in seen.log)
print()
_ = try_out(ways_to_spin.park_in_finally, interrupt_at="tick")

# %% [markdown]
# ## When it goes wrong
#
# **Spinning inside a callback.** A planner needs a map. Another callback of the same node will deliver it, after 0.3 s. The
# planner waits for it in its own callback.

# %% id="spin-in-callback"
_ = try_out(ways_to_spin.wait_in_callback)

# %% [markdown]
# A **future** is a slot for a value that is still to come. `spin_until_future_complete(node, future)` spins until it has its
# result. But only one callback of this node runs at a time. While `plan` runs, the one that delivers the map cannot.
# Without the timeout, this program would hang, and no error would say so.
#
# The fix: do not wait. Say what to do *when* the map is there, and return:

# %%
_ = try_out(ways_to_spin.go_on_later)

# %% [markdown]
# Outside of callbacks, as in the last lines above, `spin_until_future_complete` is a good tool.
#
# **A rate without a spin.** This loop is a habit from ROS 1:

# %% id="rate-on-main-thread"
_ = try_out(ways_to_spin.rate_without_spin)

# %% [markdown]
# One step, and then nothing. A rate waits for a timer of the node. Timers are served while a thread spins, and the only
# thread sleeps. Use a timer with a callback, as in lesson 05.
#
# **Two spins.** Two arms, two nodes, so two threads that spin?

# %% id="two-spins"
_ = try_out(ways_to_spin.two_spins)

# %% [markdown]
# `generator already executing` means: two threads are inside one executor. Without an executor of its own, `rclpy.spin` uses
# the **global executor**, and that one cannot be shared. The second thread ends with this
# error, so nothing spins its node any more.
#
# One executor can serve many nodes. One thread is enough:

# %%
_ = try_out(ways_to_spin.one_executor)

# %% [markdown]
# **A thread left behind.** One thread spins, while the main program does something else. That is common. But how does it
# end?

# %% id="thread-at-exit" tags=["nbval-ignore-output"]
left_behind = try_out(ways_to_spin.thread_left_behind)

# %%
print("it did its work:", "the work is done" in left_behind.log)
print("and then it crashed:", left_behind.signal is not None)

# %% [markdown]
# The work is done, and then the program *aborts*: at its end, Python stops the thread in the middle of C++ code. You see
# `terminate called without an active exception` or another error, and a service manager sees a crash at each stop.
#
# Code that starts a thread must also end it. First shut the executor down, so that `spin` returns. Then wait for the thread.

# %%
_ = try_out(ways_to_spin.thread_ended)

# %% [markdown]
# **A timer that takes every iteration.** It is due every 10 ms, and its callback takes 20 ms. So it is always ready.
# Five messages wait. We spin for two seconds, twice. First, each call gets all the remaining time as its timeout;
# then each gets 50 ms.

# %% id="unfair-turns"
print("timeout_sec=left")
_ = try_out(ways_to_spin.busy_timer, 0)
print("\ntimeout_sec=0.05")
_ = try_out(ways_to_spin.busy_timer, 0.05, show_code=False)

# %% [markdown]
# When several things are ready, the executor normally serves all of them, one per call, before it checks again. But
# when the timeout *differs* from that of the call before, it starts again with the first timer. With `left` as the
# timeout, it does so in each call. So use the same timeout in each iteration. (A timer whose callback takes longer than
# its period is a fault by itself: lesson 10.)

# %% [markdown]
# ## From a worked example to your own
#
# **Worked.** "Wait until the robot has heard a word, but at most two seconds." Three things make such a loop safe: a condition
# that ends it, a time that ends it, and short waits with the *same* timeout. It may end late, by up to one wait.
# Where that matters, use `min(left, 0.1)`: then only the last wait is shorter. Compute `left` once per iteration, and
# check it: a *negative* timeout waits forever.


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
print(
    "heard a word in half a second of silence:",
    wait_until(robot, lambda: robot.done, 0.5),
)
say("stop", "wait")
print(
    "heard a word when there were some:       ",
    wait_until(robot, lambda: robot.done, 2.0),
)
print(robot.done)

# %% [markdown]
# It returned after the first word, and left the second one in the queue. That is what the condition said.
#
# **Faded.** Now all three words are wanted. Fill in what is `...`. Until then the cell runs, and says what is missing.

# %%
# TODO: a function without arguments: has the robot done three things?
all_three = ...

robot = fresh(slow_robot)
say("turn", "wave", "walk")
if all_three is ...:
    print("Fill in the condition, then run this cell again.")
else:
    print("heard all three:", wait_until(robot, all_three, 2.0), robot.done)

# %% [markdown]
# **Your own.** In the [exercise](../exercises/06_spinning.ipynb) you write a function that lets a node work for some seconds, and then
# returns. The judge tries it with two robots: one with timers, slow callbacks and a burst of words, and a quiet one.

# %% [markdown]
# ## Check yourself
#
# **1. Ten messages wait, two timers are due. How many calls of `spin_once` does it take to handle what is there?**
#
# <details><summary>a) One</summary>
#
# ✗ One call runs one callback. You saw five words need five calls.
#
# </details>
# <details><summary>b) Three: one for each timer, one for the queue</summary>
#
# ✗ A queue is not handled as a whole. Each message needs a call of its own.
#
# </details>
# <details><summary>c) Twelve</summary>
#
# ✓ Ten messages and two ticks are twelve callbacks. And more, if the timers are due again meanwhile.
#
# </details>
#
# **2. A loop calls `spin_once(node, timeout_sec=0.5)`. A message arrives while it waits. When is it handled?**
#
# <details><summary>a) At once</summary>
#
# ✓ The message ends the wait. The timeout counts only when nothing comes.
#
# </details>
# <details><summary>b) At the end of the half second</summary>
#
# ✗ That would be polling. The timeout ends the wait only if nothing comes.
#
# </details>
# <details><summary>c) It is lost, since the call was waiting for something else</summary>
#
# ✗ It waits for whatever comes first: a message, a timer, the end of the timeout.
#
# </details>
#
# **3. Which line is the worst idea in the callback of a timer?**
#
# <details><summary>a) <code>self.publisher.publish(message)</code></summary>
#
# ✗ That is what most timers are for. It does not wait.
#
# </details>
# <details><summary>b) <code>rclpy.spin_until_future_complete(self, future)</code></summary>
#
# ✓ It waits for another callback of this node, which may not run before this one is over. Without a timeout it waits
# for good.
#
# </details>
# <details><summary>c) <code>future.add_done_callback(self.on_result)</code></summary>
#
# ✗ That is the fix: say what to do later, and return.
#
# </details>
#
# **4. A thread of your program runs `executor.spin()`. The work is done. How should the program end?**
#
# <details><summary>a) With nothing: as a daemon thread, it ends with the program</summary>
#
# ✗ Python stops it in the middle of C++ code, and the program may abort.
#
# </details>
# <details><summary>b) With <code>thread.join()</code>, and then <code>executor.shutdown()</code></summary>
#
# ✗ `join` waits until `spin` returns. The line that would make it return comes too late.
#
# </details>
# <details><summary>c) With <code>executor.shutdown()</code>, and then <code>thread.join()</code></summary>
#
# ✓ The first line makes `spin` return. The second one waits until the thread has ended.
#
# </details>

# %% [markdown]
# ## Talk it through
#
# Copy the prompt for an AI assistant, or discuss it with a colleague. State your own view first.
#
# ```text
# I program a robot with ROS 2 Jazzy in Python (rclpy). My program reads a joystick in a
# loop (`while True: read, publish, sleep 20 ms`) and must also react to
# `/emergency_stop`. Where do I put the spinning? Compare at least three ways. Name only
# functions that exist in rclpy for Jazzy.
# ```
#
# <details><summary>What a good answer contains</summary>
#
# The loop never spins, so the emergency stop would wait in its queue for good. There are three ways out:
#
# 1. Turn the loop into a timer of 20 ms and call `rclpy.spin`. This is the usual answer. Reading the joystick must then
#    never block.
# 2. Keep the loop, and replace the sleep by spinning until the 20 ms are over. Call `spin_once` with a short timeout
#    again and again, because one call runs only one callback. The stop is then handled within one callback's time. With
#    `timeout_sec=0` instead of the sleep, the loop would keep a processor busy.
# 3. Spin in a thread of its own, with an executor of its own, and end it with `shutdown` and `join`. This is right when
#    the library that reads the joystick blocks. Then two threads touch the same data.
#
# A good answer also asks how fast the robot must stop, and whether a stop should depend on one Python loop at all.
#
# </details>
#
# <details><summary>What to check in the reply</summary>
#
# Two claims you may meet. Both are wrong: each was tried with the rclpy of this course.
#
# - **`rclpy.spin_some(node)`:** That is C++ (rclcpp). rclpy has `spin_once`.
# - **`spin_once(node, timeout_sec=0)` handles everything that waits:** In fact, it runs one callback. Five waiting
#   messages need five calls.
#
# </details>

# %% [markdown]
# ## Take away
#
# - Callbacks run only while a thread spins the node, and in that thread.
# - `spin_once` runs one callback, and returns nothing. `spin` repeats it until the context is shut down.
# - Give every `spin_once` the same short timeout. None, or a negative one, blocks forever; 0 keeps a processor busy.
# - Do not spin or sleep inside a callback. Return, and let another callback go on.
# - One executor can serve many nodes. If you spin in a thread, shut the executor down and join the thread.
#
# **Before:** [05 · Timers](05_timers.ipynb)
#
# **Next:** [07 · Typed nodes](07_typed_nodes.ipynb), where a machine reads your node before it runs.
#
# **More:** [About executors](https://docs.ros.org/en/jazzy/Concepts/Intermediate/About-Executors.html), and
# [rclpy](https://docs.ros.org/en/jazzy/p/rclpy), whose functions you called here.
