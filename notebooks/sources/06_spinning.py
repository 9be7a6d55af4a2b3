# %% [markdown]
# # 06 · Spinning
#
# A robot that nobody spins has ears and clocks, and does nothing: spinning is what lets its callbacks run.
#
# - **Minutes:** 50
# - **You need:** lessons [04](04_subscriptions_and_callbacks.ipynb) and [05](05_timers.ipynb): what a subscription and
#   a timer call
# - **You will be able to:** say what `spin` and `spin_once` do, turn the crank of a node by hand, give every wait an
#   end, and recognize five ways to get stuck
# - **Left out:** several threads that share the work (lesson 10), services (lesson 12)

# %% [markdown]
# Here is a robot that you crank by hand. Both of its arms have timers. For two seconds we do nothing. Then we
# turn the crank sixty times: each `spin_once` is one turn. Watch the arms.

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
print("moved while nobody turned the crank:", list(arms.angles) != at_first)

for _ in range(60):
    rclpy.spin_once(arms, timeout_sec=0.1)
    figure_of_it.show(humanoid.draw(arms.angles))
print("moved while somebody did:", list(arms.angles) != at_first)

# %% [markdown]
# You were the engine of this robot. In a real program `rclpy.spin` turns the crank for you. This lesson is about what
# happens in one turn.

# %% [markdown] prediction="five-words"
# ## Predict
#
# A robot listens on `/robot/words`. Somebody says five words. They have arrived, and wait in the robot's queue. Then
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
#   ✓ One call of `spin_once` runs one callback, and each word has a callback of its own. Four words go on waiting.
# - **b** 5: one spin handles all that has come.
#   when `heard == 5`
#   ✗ `spin_once` runs one callback and returns. Each word that waits needs a call of its own.
# - **c** As many as fit into half a second.
#   when `1 < heard < 5`
#   ✗ The timeout is no time to work in. It is the longest time that the call waits when nothing is ready.
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
# First we speak, and do not spin at all.

# %% id="forgotten-spin"
from rclpy.node import Node
from std_msgs.msg import String

from lesson_nodes.attentive_robot import AttentiveRobot

mouth = fresh(Node, "mouth").create_publisher(String, "/robot/words", 10)


def slow_robot():
    """A robot whose timers tick once in 1000 s."""
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
            raise TimeoutError("nobody listens on /robot/words")
        time.sleep(0.01)
    for word in words:
        mouth.publish(String(data=word))
    time.sleep(0.2)


robot = fresh(slow_robot)
say("stop", "wait", "turn", "wave", "walk")
time.sleep(1.0)
print("heard after more than a second:", robot.done)

# %% [markdown]
# Silence. No error, no warning: this is what a **forgotten spin** looks like. Speaking worked, though: `publish` needs
# nobody to spin. Now one turn of the crank, and then four more.

# %% id="one-is-not-all"
rclpy.spin_once(robot, timeout_sec=0.5)
print("after one spin_once:", robot.done)
reveal("five-words", heard=len(robot.done))

# %%
for turn in range(4):
    rclpy.spin_once(robot, timeout_sec=0.5)
    print(f"after {turn + 2}:", robot.done)

# %% [markdown]
# ## Look inside
#
# A message that arrives does not call you. The DDS layer puts it into the queue of the subscription, in a thread of its
# own, and that is all. A timer does not call you either: it only knows when it is due. Both wait until somebody asks.
#
# The one who asks is the **executor**. `rclpy.spin_once(node)` lends the node to it for one turn:
#
# 1. Is something ready: a message in a queue, a timer that is due? If not, wait until something is, or until the
#    timeout is over.
# 2. Take **one** ready thing and run its callback, in the very thread that called `spin_once`.
# 3. Come back. It returns `None`, whether a callback ran or not.
#
# And `rclpy.spin(node)`? Leave out the book-keeping, and this is the whole of it:
#
# ```python
# while rclpy.ok():
#     executor.spin_once()
# ```
#
# So spinning is no magic in the background. It is *your* thread, which goes round a loop. That is why it is called the
# heartbeat of a node.
#
# Now with timers. The heart beats every 1.0 s, the robot looks around every 2.1 s, and three words are said. Then both
# timers start anew (`reset`), and we look away for 2.2 s. Now much is ready: both timers are due and three words wait.
# We turn the crank eight times, and note what ran in each turn and how long it waited.

# %%
robot = fresh(AttentiveRobot)
say("stop", "wait", "turn")
for timer in robot.timers:
    timer.reset()
time.sleep(2.2)

turns = []
for turn in range(1, 9):
    before, began = len(robot.done), time.monotonic()
    rclpy.spin_once(robot, timeout_sec=2.0)
    turns.append((turn, robot.done[before:], time.monotonic() - began))

for turn, ran, _ in turns:
    print(f"call {turn}: {len(ran)} callback: {', '.join(ran)}")

# %%
from workbook.pictures.figures import figure, show
from workbook.pictures.palette import AMBER, BLUE, GREEN, RED

ROWS = {"heard": BLUE, "look": AMBER, "beat": GREEN}
fig, (above, below) = figure(6.4, 3.6, rows=2)
for turn, ran, waited in turns:
    kind, _, word = ran[0].partition(" ")
    row = list(ROWS).index(kind)
    above.plot(turn, row, "s", markersize=16, color=ROWS[kind])
    above.annotate(word, (turn, row - 0.75), ha="center", fontsize=9)
    below.bar(turn, waited, color=BLUE, width=0.5)
above.set(yticks=range(3), yticklabels=ROWS, ylim=(-1.0, 2.6), xticks=range(1, 9), xlim=(0.4, 8.6))
below.set(xlabel="call of spin_once", ylabel="waited (s)", xticks=range(1, 9), xlim=(0.4, 8.6))
for axes in (above, below):
    axes.grid(False, axis="x")
show(fig, "calls 1 to 5 ran beat, look and three words at once; calls 6 to 8 waited for beat, beat and look")

# %%
waits = [waited for _, _, waited in turns]
print("each call ran one callback:", all(len(ran) == 1 for _, ran, _ in turns))
print("the last three waited longer than the first five:", sum(waits[5:]) > sum(waits[:5]))

# %% [markdown]
# Read it from left to right. Calls 1 and 2 take the timers, call 3 a word. Of the words one is taken each time, in the
# order in which they came. From call 6 on nothing is ready any more, so `spin_once` *waits*, and wakes up on the very
# moment at which the next timer is due.
#
# Which of the ready things comes first is the executor's business: in this version timers come before messages. Do not
# build on it. Note also what is missing: the heart was due at 1.0 s *and* at 2.0 s, and beat once. You know
# why from [lesson 05](05_timers.ipynb).

# %% [markdown]
# ## Change it
#
# What follows can get stuck, on purpose. So each piece runs as a program of its own behind a **watchdog**, which ends
# it when nothing has come from it for four seconds. `try_out` prints what the program said, and how it ended.

# %%
from workbook.lesson import run_program

HEAD = """
import threading
import time

import rclpy
from rclpy.node import Node
from rclpy.task import Future

rclpy.init()
node = Node("robot")
"""


def try_out(code, interrupt_at=None):
    """Run a program; print its words (of a traceback only the error), and how it ended."""
    seen = run_program(HEAD + code, silence=4.0, interrupt_at=interrupt_at)
    for line in seen.log.splitlines():
        if line.strip() and not line.startswith((" ", "Traceback")):
            print("  |", line)
    if seen.ended_by == "bench":
        print("the watchdog had to end it")
    else:
        print("it ended with", f"signal {seen.signal}" if seen.signal else f"exit code {seen.exit}")
    return seen


_ = try_out('print("I am", node.get_name())')

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
seen = try_out("""
print("before", flush=True)
rclpy.spin_once(node)
print("after", flush=True)
""")
reveal("no-timeout", came_back="after" in seen.log)

# %% [markdown]
# "once" means *one callback*, not *one look*. Without a timeout it waits for that callback as long as it takes. Here
# nothing will ever be ready, so that is forever. The word "after" never comes.
#
# Mind that this bug hides: as long as the robot has a timer, something is ready soon. It shows when the robot falls
# silent.

# %%
_ = try_out("""
print("before", flush=True)
rclpy.spin_once(node, timeout_sec=0.5)  # turn this knob
print("after", flush=True)
""")

# %% [markdown]
# In a notebook, in a test, in every program that has something else to do: **always give `timeout_sec`**.

# %% [markdown] prediction="timeout-zero"
# ### Experiment 2: the other end of the knob
#
# If waiting is dangerous, why wait at all? With `timeout_sec=0` the call only looks, and comes back at once. Three
# loops serve the same 10 Hz timer until it has ticked twenty times, with timeouts of 0, 0.01 and 0.1 s. What do you
# expect of the first?
#
# - **a** It takes as long, and keeps a processor busy all the time.
#   when `soonest_s > 1.9 and times_as_many_calls > 5`
#   ✓ The ticks come when they are due, so it takes as long. In between, the loop never sleeps.
# - **b** It takes as long, and hardly more work: looking costs nothing.
#   when `soonest_s > 1.9 and times_as_many_calls <= 5`
#   ✗ Each call asks the middleware what is ready. One call is cheap, many thousands a second are not.
# - **c** It has its twenty ticks before the others, for it looks more often.
#   when `soonest_s <= 1.9`
#   ✗ The timer decides when a tick is due. To ask more often does not bring it forward.

# %%
predict("timeout-zero")

# %%
METER = """
ticks = []
node.create_timer(0.1, lambda: ticks.append(1))
turns, busy, begin = 0, time.process_time(), time.monotonic()
while len(ticks) < 20:
    rclpy.spin_once(node, timeout_sec=TIMEOUT)
    turns += 1
print(turns, time.monotonic() - begin, time.process_time() - busy)
"""

meters = {}
for timeout_s in (0, 0.01, 0.1):
    seen = run_program(HEAD + METER.replace("TIMEOUT", str(timeout_s)))
    meters[timeout_s] = tuple(map(float, seen.log.split()[-3:]))

fig, axes = figure(6.4, 2.4)
for row, (turn_count, took_s, busy_s) in enumerate(meters.values()):
    share = busy_s / took_s
    axes.barh(row, 100 * share, color=GREEN if row else RED, height=0.55)
    axes.annotate(f" {turn_count:,.0f} turns", (100 * share, row), va="center", fontsize=9)
names = [f"timeout_sec={timeout_s}" for timeout_s in meters]
axes.set(yticks=range(3), yticklabels=names, xlabel="share of one processor (%)", xlim=(0, 135))
axes.set_xticks(range(0, 101, 25))
axes.grid(False, axis="y")
axes.invert_yaxis()
show(fig, "the loop with timeout 0 takes most of a processor for thousands of turns, the others hardly anything")

# %% id="busy-loop"
soonest = min(took_s for _, took_s, _ in meters.values())
print("nobody had twenty ticks before two seconds were over:", soonest > 1.9)
rounds = {timeout_s: turn_count for timeout_s, (turn_count, _, _) in meters.items()}
print("timeout 0 went round more than 5 times as often as 0.1 s:", rounds[0] > 5 * rounds[0.1])
reveal("timeout-zero", soonest_s=soonest, times_as_many_calls=rounds[0] / rounds[0.1])

# %% [markdown]
# This is called a **busy loop**. On a robot with a battery it is a heater. And a longer timeout makes nothing slower: a
# callback that becomes ready ends the wait at once, as you saw in the stepper. A timeout is how long you can stand
# *nothing* to happen. It is no period.

# %% [markdown] prediction="after-spin"
# ### Experiment 3: what comes after `spin`
#
# The robot shall park its arm at the end:
#
# ```python
# rclpy.spin(node)
# print("arm parked")
# ```
#
# When is the arm parked?
#
# - **a** At once: `spin` starts the node in the background, and the program goes on.
#   when `parked_by_itself`
#   ✗ `spin` runs in this thread, and returns only when the context is shut down. There is no background.
# - **b** When somebody presses Ctrl-C.
#   when `parked_after_ctrl_c and not parked_by_itself`
#   ✗ Ctrl-C does end `spin`, but with the exception `KeyboardInterrupt`. The line after it is skipped.
# - **c** Never.
#   when `not parked_after_ctrl_c and not parked_by_itself`
#   ✓ Without Ctrl-C, `spin` does not return. With it, an exception leaves `spin` and skips the next line. A `finally`
#   would run.

# %%
predict("after-spin")

# %% id="after-spin"
PARK = """
def tick():
    print("tick", flush=True)
    timer.cancel()

timer = node.create_timer(0.2, tick)
rclpy.spin(node)
print("arm parked", flush=True)
"""

print("nobody presses Ctrl-C:")
alone = try_out(PARK)
print("\nCtrl-C after the first tick:")
seen = try_out(PARK, interrupt_at="tick")
print("\nthe arm was parked:", "arm parked" in seen.log)
reveal(
    "after-spin",
    parked_by_itself="arm parked" in alone.log,
    parked_after_ctrl_c="arm parked" in seen.log,
)

# %% [markdown]
# `spin` does not come back while ROS is up. And on Ctrl-C it does not come back either: it is *left*, by a
# `KeyboardInterrupt`, and the line after it is jumped over. What must be done at the end belongs in `finally`:

# %%
_ = try_out(
    """
def tick():
    print("tick", flush=True)
    timer.cancel()

timer = node.create_timer(0.2, tick)
try:
    rclpy.spin(node)
except KeyboardInterrupt:
    pass
finally:
    print("arm parked", flush=True)
    rclpy.try_shutdown()
""",
    interrupt_at="tick",
)

# %% [markdown]
# ## When it goes wrong
#
# **Spinning inside a callback.** A planner needs a map. Another callback of the same node will deliver it, after 0.3 s.
# "I wait for it right here", thinks the planner, in its own callback.

# %% id="spin-in-callback"
_ = try_out("""
map_is_there = Future()
node.create_timer(0.3, lambda: map_is_there.done() or map_is_there.set_result("a map"))

def plan():
    planner.cancel()
    rclpy.spin_until_future_complete(node, map_is_there, timeout_sec=1.0)
    print("after 1 s of waiting in the callback:", map_is_there.done(), flush=True)

planner = node.create_timer(0.1, plan)
end = time.monotonic() + 2.0
while time.monotonic() < end:
    rclpy.spin_once(node, timeout_sec=0.1)
print("when the callback was over:", map_is_there.done(), flush=True)
""")

# %% [markdown]
# `spin_until_future_complete(node, future)` spins until somebody gives the **future** its result: a slot for a value
# that is still to come. But the callbacks of a node take turns. As long as `plan` runs, none of its sisters may, the
# one that delivers the map included. Without the timeout, this program would stand still for good, and no error would
# say so.
#
# The way out: do not wait. Say what is to be done *when* the map is there, and come back:

# %%
_ = try_out("""
map_is_there = Future()
node.create_timer(0.3, lambda: map_is_there.done() or map_is_there.set_result("a map"))

def plan():
    planner.cancel()
    map_is_there.add_done_callback(lambda future: print("planning with", future.result(), flush=True))

planner = node.create_timer(0.1, plan)
rclpy.spin_until_future_complete(node, map_is_there)
rclpy.spin_once(node, timeout_sec=0.1)
""")

# %% [markdown]
# At the top level of a program, outside of callbacks, `spin_until_future_complete` is a good tool. You see it here.
#
# **A rate that nobody feeds.** From ROS 1, or from a colleague, comes this loop:

# %% id="rate-on-main-thread"
_ = try_out("""
rate = node.create_rate(10)
for _ in range(5):
    print("step", flush=True)
    rate.sleep()
""")

# %% [markdown]
# One step, and then silence. A rate is a timer in disguise: its `sleep` waits until that timer ticks. Timers tick while
# somebody spins, and the only one who could is asleep. It works beside a thread that spins. A timer with a callback, as
# in lesson 05, needs no second thread.
#
# **Two spins.** Two arms, two nodes, so two threads that spin?

# %% id="two-spins"
_ = try_out("""
other = Node("other")
ticks = {"robot": 0, "other": 0}

def count(name):
    ticks[name] += 1

node.create_timer(0.1, lambda: count("robot"))
other.create_timer(0.1, lambda: count("other"))

first = threading.Thread(target=rclpy.spin, args=(node,), name="spin 1")
second = threading.Thread(target=rclpy.spin, args=(other,), name="spin 2")
first.start()
time.sleep(0.5)
second.start()
time.sleep(1.0)
print("robot ticks:", ticks["robot"] > 0, flush=True)
print("other keeps ticking:", ticks["other"] > 3, flush=True)
rclpy.shutdown()
""")

# %% [markdown]
# `generator already executing` is Python's way to say: two threads are inside of one executor. Unless you hand it another
# one, `rclpy.spin` uses the same **global executor** each time, and that one cannot be shared. The second thread
# dies, its node is deaf, and the program goes on as if nothing had happened.
#
# One executor can serve many nodes. One thread is enough:

# %%
_ = try_out("""
from rclpy.executors import SingleThreadedExecutor

other = Node("other")
ticks = {"robot": 0, "other": 0}

def count(name):
    ticks[name] += 1

node.create_timer(0.1, lambda: count("robot"))
other.create_timer(0.1, lambda: count("other"))

executor = SingleThreadedExecutor()
executor.add_node(node)
executor.add_node(other)
end = time.monotonic() + 1.0
while time.monotonic() < end:
    executor.spin_once(timeout_sec=0.1)
print("both tick:", min(ticks.values()) > 0)
""")

# %% [markdown]
# **A thread left behind.** One thread that spins, while the main program does something else: that is fine, and common.
# But how does it end?

# %% id="thread-at-exit" tags=["nbval-ignore-output"]
LEFT = """
node.create_timer(0.05, lambda: None)
threading.Thread(target=rclpy.spin, args=(node,), daemon=True).start()
time.sleep(0.5)
print("the work is done", flush=True)
"""
left_behind = try_out(LEFT)

# %%
print("it did its work:", "the work is done" in left_behind.log)
print("and then it crashed:", left_behind.signal is not None)

# %% [markdown]
# The work is done, and then the program *aborts*. When Python goes down, it takes the thread away in the middle of C++
# code that is not prepared for it: `terminate called without an active exception`, or once in a while another last cry,
# depending on what the thread was at. In a terminal you see `Aborted (core dumped)`, and a service manager sees a crash at
# each stop. A node without timers may get away with it, which makes it a nasty bug.
#
# Whoever starts a thread ends it: first shut the executor down, so that `spin` comes back, then wait for the thread.

# %%
_ = try_out("""
from rclpy.executors import SingleThreadedExecutor

node.create_timer(0.05, lambda: None)
executor = SingleThreadedExecutor()
executor.add_node(node)
thread = threading.Thread(target=executor.spin)
thread.start()
time.sleep(0.5)
print("the work is done", flush=True)
executor.shutdown()  # spin comes back
thread.join()        # wait until it has
rclpy.shutdown()
""")

# %% [markdown]
# **A timer that takes every turn.** It is due every 10 ms, and its callback takes 20 ms. So it is always ready. Five
# messages wait, and we spin for two seconds. In the first loop a turn may wait for all the time that is left, in the second
# for 50 ms.

# %% id="unfair-turns"
BUSY = """
from std_msgs.msg import String

heard = []
node.create_timer(0.01, lambda: time.sleep(0.02))
node.create_subscription(String, "/robot/words", lambda message: heard.append(message.data), 10)
mouth = node.create_publisher(String, "/robot/words", 10)
while mouth.get_subscription_count() == 0:
    time.sleep(0.01)
for word in ("stop", "wait", "turn", "wave", "walk"):
    mouth.publish(String(data=word))
time.sleep(0.2)  # by now the words are there, and the timer is overdue

end = time.monotonic() + 2.0
while (left := end - time.monotonic()) > 0:
    rclpy.spin_once(node, timeout_sec=TIMEOUT)
print("heard:", len(heard), "of 5")
"""

print("timeout_sec=left")
_ = try_out(BUSY.replace("TIMEOUT", "left"))
print("timeout_sec=0.05")
_ = try_out(BUSY.replace("TIMEOUT", "0.05"))

# %% [markdown]
# When several things are ready, the executor serves all of them, one per call, before it looks again: timers first, then
# subscriptions. But it begins a new round whenever it is called with *another timeout* than the time before. With `left`
# that is each time, and each round begins with the timer. So give it the same timeout in each turn. (And a timer whose
# callback takes longer than its period is a bug of its own: lesson 10.)

# %% [markdown]
# ## From a worked example to your own
#
# **Worked.** "Wait until the robot has heard a word, but at most two seconds." Three things make such a loop
# safe: a condition that ends it, a moment that ends it, and waits that are short and never longer than what is left.
# (What is left is worked out once per turn, and looked at. A *negative* timeout waits for good, as none at all does.)

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
print("heard a word in half a second of silence:", wait_until(robot, lambda: robot.done, 0.5))
say("stop", "wait")
print("heard a word when there were some:       ", wait_until(robot, lambda: robot.done, 2.0))
print(robot.done)

# %% [markdown]
# It came back after the first word, and left the second one in the queue. That is what the condition said.
#
# **Faded.** Now all three words are wanted. Fill in what is `...`. Until then the cell runs, and says what is missing.

# %%
all_three = ...  # TODO: a function without arguments that says whether the robot has done three things

robot = fresh(slow_robot)
say("turn", "wave", "walk")
if all_three is ...:
    print("Fill in the condition, then run this cell again.")
else:
    print("heard all three:", wait_until(robot, all_three, 2.0), robot.done)

# %% [markdown]
# **Your own.** In the [exercise](../exercises/06_spinning.ipynb) you write a pump: let a node work for so many seconds,
# and come back. It is judged by a robot with timers, a burst of words, slow callbacks, and a robot that says nothing.

# %% [markdown]
# ## Check yourself
#
# **1. Ten messages wait, two timers are due. How many `spin_once` does it take to handle what is there?**
#
# <details><summary>a) One</summary>
#
# ✗ One call runs one callback. You saw five words need five calls.
#
# </details>
# <details><summary>b) Three: one for each timer, one for the queue</summary>
#
# ✗ A queue is not handled as a whole. Each message has a callback of its own.
#
# </details>
# <details><summary>c) Twelve</summary>
#
# ✓ Ten messages and two ticks are twelve callbacks. And more, if the timers fall due again meanwhile.
#
# </details>
#
# **2. A loop calls `spin_once(node, timeout_sec=0.5)`. A message arrives while it waits. When is it handled?**
#
# <details><summary>a) At once</summary>
#
# ✓ The message ends the wait. The timeout says how long the loop can stand silence.
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
# ✗ That is the cure: note what is to be done later, and come back.
#
# </details>
#
# **4. Two nodes in one program. How do both get their heartbeat?**
#
# <details><summary>a) <code>rclpy.spin(left)</code>, and in the next line <code>rclpy.spin(right)</code></summary>
#
# ✗ The next line is not reached while ROS is up, and Ctrl-C jumps over it. `right` is never spun.
#
# </details>
# <details><summary>b) Two threads, one with <code>rclpy.spin(left)</code> and one with <code>rclpy.spin(right)</code></summary>
#
# ✗ Both use the global executor. The second thread dies with "generator already executing".
#
# </details>
# <details><summary>c) One executor with both nodes added, and one spin</summary>
#
# ✓ An executor serves as many nodes as you add. They share its thread and take turns.
#
# </details>

# %% [markdown]
# ## Talk it through
#
# Discuss this with a colleague or an AI assistant:
#
# > My program reads a joystick in a loop (`while True: read, publish, sleep 20 ms`) and shall also react to
# > `/emergency_stop`. Where do I put the spinning? Compare at least three ways.
#
# <details><summary>What a good answer contains</summary>
#
# The loop never spins, so the emergency stop would wait in its queue for good. Three ways. (1) Turn the loop into a
# timer of 20 ms and call `rclpy.spin`: the usual answer; reading the joystick must then never block. (2) Keep the loop,
# and replace the sleep by spinning until the 20 ms are over: `spin_once` with a short timeout, again and again, for one
# call runs only one callback. The stop is then handled within one callback's time. With `timeout_sec=0` in
# place of the sleep it would burn a processor. (3) Spin in a thread of its own, with an executor of its own, and end it
# with `shutdown` and `join`: right when the library that reads the joystick blocks. Then two threads touch the same
# data. A good answer also asks how fast the robot must stop, and whether a stop should hang on one Python loop at all.
#
# </details>

# %% [markdown]
# ## Take away
#
# - Callbacks run while somebody spins, in the thread of the one who spins, and at no other time.
# - `spin_once` runs one callback, and returns nothing; `spin` is a loop of it that ends with ROS.
# - Give every `spin_once` a timeout that fits: none at all, or a negative one, blocks for good; 0 burns a processor.
# - Do not spin or sleep inside a callback. Come back, and let another callback go on.
# - One executor can serve many nodes. Whoever spins in a thread shuts the executor down and joins the thread.
#
# **Before:** [05 · Timers](05_timers.ipynb)
#
# **Next:** [07 · Typed nodes](07_typed_nodes.ipynb), where a machine reads your node before it runs.
#
# **More:** [About executors](https://docs.ros.org/en/jazzy/Concepts/Intermediate/About-Executors.html), and
# [rclpy](https://docs.ros.org/en/jazzy/p/rclpy), whose functions you called here.
