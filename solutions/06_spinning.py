# ---
# exercise: 06_spinning
# title: Spin for a given time
# minutes: 25
# difficulty: 3
# kind: function
# clock: wall
# objectives:
#   - run the callbacks of a node for a given time, then return
#   - give every wait the right timeout
#   - wait without using the processor
#   - leave a node as you found it
# out_of_scope:
#   - interrupting a running callback
#   - running callbacks at the same time, in several threads (lesson 10)
#   - exceptions that a callback raises
# ---
# %% [markdown]
# # Exercise 06 · Spin for a given time
#
# Your humanoid stands in a test stand. The test stand is an ordinary Python program. It moves an arm, lets the robot
# work for a second and a half, reads a gauge, and lets it work for another second. It cannot use `rclpy.spin`, because
# that does not return. It needs a function that *spins a node for some seconds and then returns*. The function is
# called `pump`, because it keeps callbacks flowing like a pump.
#
# **About 25 minutes · difficulty 3 of 5 · 10 points.** You need lesson [06](../notebooks/06_spinning.ipynb).
#
# ## What to build
#
# One function, `pump(node, seconds)`. It creates no node and does not call `rclpy.init`: the test stand does both.
#
# | | what `pump` does |
# |---|---|
# | while the time runs | runs every callback of `node` that is ready: timers and subscriptions |
# | when the time is up | returns: not earlier, and at most one callback later; a callback that has begun is finished |
# | as long as nothing is ready | waits, and does not use the processor |
# | after that | nothing that it started keeps running; the node is as it was, and `pump` can be called again |
#
# ## What is judged
#
# A driver imports your file and calls `pump` eight times, for 0.05 s to 2.1 s. Its robot has a heartbeat (10 Hz), looks
# around (2 Hz), repeats each word that it receives, and has slow jobs of 0.4 s. A second robot is quiet: it has no
# timer, and receives four words, two of them near the end. A third one has only slow jobs. All robots publish what
# they do. The driver publishes when each call begins and ends, and what the call changed on the node. It also says
# whether a thread of the call goes on after it. (A thread of a pool that only waits for work does not count.)
#
# | points | criterion |
# |---:|---|
# | 1 | `pump` returns |
# | 1 | after 2.1 s when asked for 2.1 s: at most 0.05 s earlier, at most 0.25 s later in the median of its calls |
# | 2 | each of the 20 words that come in a burst is handled during the call |
# | 1 | the timers keep their rate meanwhile: 80 % of the heartbeats or more, no silence over 0.3 s |
# | 1 | further calls work, too: the second call handles the words that waited in the queue, and the short calls run callbacks, too |
# | 1 | a queue of slow jobs delays its return by at most one job (0.4 s) and 0.25 s |
# | 1 | it returns in time (0.25 s) from the quiet robot, too, and handles its words |
# | 1 | it uses less than 12 % of a processor with the quiet robot, and less than 40 % with the one that has timers |
# | 1 | between two calls no callback and no thread of `pump` runs; the node has the same timers, periods, subscriptions, guard conditions and parameters |
#
# **Not part of it:** stopping a running callback, several threads, callbacks that raise, and simulated time. (Seconds
# are real time, and so is the clock of the robots.)
# %% [answer]
"""Spins a node for a given time."""

# [solution]
import time

# [end]
import rclpy
from rclpy.node import Node

# [solution]
TURN_S = 0.05  # with the same timeout each time, the executor serves all that is ready before it starts again

# [end]

def pump(node: Node, seconds: float) -> None:
    """Run the callbacks of a node for some time, then return.

    Args:
        node: The node that shall work. It is left as it is.
        seconds: How long, in seconds of real time.
    """
    # [solution]
    end = time.monotonic() + seconds
    while (left := end - time.monotonic()) > 0:
        rclpy.spin_once(node, timeout_sec=min(left, TURN_S))
    # [starter]
    # | # TODO 1: compute the time at which to stop
    # | # TODO 2: continue until that time, in short waits with the same timeout
    # | rclpy.spin_once(node, timeout_sec=seconds)
    # [end]


# %% [live]
# from lesson_nodes.pump_watcher import PumpWatcher
# from workbook.lesson import fresh, init, run
# from workbook.pictures.figures import show
# from workbook.pictures.timeline import strip
#
# %start
# init()
# watcher = fresh(PumpWatcher)  # asks for pump(robot, 2.0), and sends ten words after a second
# await run(watcher, seconds=4.0)
# print("pump(robot, 2.0) took", "too long" if watcher.took is None else f"{watcher.took:.2f} s")
# picture = strip(watcher.rows, periods={"heartbeats": 0.1}, end=3.0, noun="marks")
# show(picture, "start and end of the call, the heartbeats of the robot, and the words that it handled")
# %% [hint]
# The starter waits for one callback and then returns. What would you do by hand? Look at the clock, let the robot do
# one thing, look at the clock again. That is a loop. Two questions decide whether it is a good one: what ends it, and
# how long may each iteration wait at most?
#
# What spinning is: [About executors](https://docs.ros.org/en/jazzy/Concepts/Intermediate/About-Executors.html)
# %% [hint]
# - The end is a time, not a number of iterations: `time.monotonic() + seconds`, computed once, before the loop.
#   `time.monotonic()` is a clock that is never set back.
# - An iteration that may wait longer than the time left returns too late from a quiet node. An iteration that may not
#   wait at all (`timeout_sec=0`) keeps the processor busy.
# - `timeout_sec=None`, no timeout, or a *negative* one waits forever. So compute the time left once, and check it
#   before you use it.
# - The node is not yours, so leave it as it is: no `destroy_node`, no `shutdown`, no thread that keeps running.
#
# The calls: [rclpy](https://docs.ros.org/en/jazzy/p/rclpy)
# %% [hint]
# The whole function, with gaps:
#
# ```python
# def pump(node: Node, seconds: float) -> None:
#     end = time.monotonic() + ___
#     while (left := end - ___) > 0:
#         rclpy.spin_once(node, timeout_sec=min(left, ___))
# ```
#
# `:=` gives a value a name in the middle of an expression. Without it, compute `left` before the loop and again at the
# end of its body.
#
# Where this is used for real, in tests: [Writing basic tests with
# Python](https://docs.ros.org/en/jazzy/Tutorials/Intermediate/Testing/Python.html)
# %% [alternatives]
# ## Other good ways
#
# - **Slices without `min`.** `while time.monotonic() < end: rclpy.spin_once(node, timeout_sec=0.05)`. This is simpler,
#   and late by one slice at most. Twenty wake-ups a second cost almost nothing, and between two slices the program can
#   do something else.
# - **`timeout_sec=left`.** This is shorter, has no needless wake-up, and gets full marks here. But with a different
#   timeout in each call, the executor starts again with the first timer each time. If that timer takes longer than its
#   period, it runs in every iteration, and messages wait forever. The lesson shows it.
# - **`rclpy.spin_until_future_complete(node, Future(), timeout_sec=seconds)`.** Nothing completes this future, so the
#   timeout ends the spin. It is one line, and rclpy does the loop with the clock. But the reader has to know the trick.
# - **A timer that completes a future after `seconds`.** This is elegant when an event ends the spin anyway. Destroy the
#   timer after that, or it keeps firing and ends the next call early.
# - **A `SingleThreadedExecutor` of your own.** `rclpy.spin_once(node)` uses the global executor and adds and removes
#   the node each time. With your own executor you add it once, which is faster when there is a lot to do. Two calls in
#   two threads then do not disturb each other. At the end, remove the node and shut the executor down; the node stays.
# - **A `MultiThreadedExecutor`.** Do not use it for this. Its `shutdown` does not wait for callbacks that already run
#   in its threads. A callback that is cut off leaves its callback group locked, and then no callback of the node runs
#   any more.
# - **Another thread that spins, and `sleep(seconds)` here.** This works if you shut the executor down and join the
#   thread before you return. But more can go wrong, and callbacks run in a thread that the caller does not expect.
# - **`node.get_clock()` instead of `time.monotonic()`.** Then `seconds` are simulated time, and in a simulation at
#   double speed the call takes half as long. Sometimes this is what you want. This task uses real time.
