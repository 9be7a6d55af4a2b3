# ---
# exercise: 06_spinning
# title: Spin for a given time
# minutes: 25
# difficulty: 3
# kind: function
# clock: wall
# objectives:
#   - running a node's callbacks for a given time, and then returning
#   - choosing the right timeout each time you wait
#   - waiting without using the processor
#   - leaving a node as you found it
# out_of_scope:
#   - interrupting a running callback
#   - running callbacks at the same time, in several threads (lesson 10)
#   - exceptions that a callback raises
# ---
# %% [markdown]
# # Exercise 06 · Spin for a given time
#
# Your humanoid is on a test stand that's controlled by an ordinary Python program. The program moves an arm, lets the
# robot's callbacks run for 1.5 s, reads a gauge, and lets the callbacks run for another second. It can't use
# `rclpy.spin`, because that call doesn't return. Instead, it needs a function that *spins a node for a given number of
# seconds and then returns*. The function is called `pump`, because it keeps callbacks flowing, the way a pump keeps
# water flowing.
#
# **About 25 minutes · difficulty 3 of 5 · 10 points.** This exercise builds on lesson
# [06](../notebooks/06_spinning.ipynb).
#
# ## What to build
#
# Write one function, `pump(node, seconds)`. It must not create a node or call `rclpy.init`, because the test stand does
# both.
#
# | when | what happens |
# |---|---|
# | until the time is up | whenever one of the node's timer or subscription callbacks is ready, `pump` runs it |
# | while no callback is ready | `pump` waits without using the processor |
# | when the time is up | `pump` returns, and no sooner. If a callback is still running, `pump` lets it finish first, so `pump` may return late, by up to that callback's duration |
# | after the call | nothing that `pump` started is still running, and the node is unchanged, so that you can call `pump` again |
#
# ## What is judged
#
# The judge runs a test program that imports your file and calls `pump` eight times, for {{ASKED_S.5}} s to
# {{ASKED_S.1}} s each. The test program uses three robots:
#
# - The first robot publishes a heartbeat (10 Hz), looks around (2 Hz), repeats each word that it receives, and runs
#   slow jobs ({{JOB_S}} s each).
# - The second robot is quiet. It has no timers, and it receives four words, two of them shortly before `pump` is due to
#   return.
# - The third robot has only slow jobs.
#
# Each robot publishes a message whenever it does something. For each call, the test program reports the start time, the
# end time, and any changes that the call made to the node. The test program also reports whether any thread that the
# call started is still running afterward. (An idle thread in a thread pool doesn't count.)
#
# | points | criterion |
# |---:|---|
# | 1 | `pump` returns |
# | 1 | `pump` returns when the time is up: `pump(node, {{ASKED_S.1}})` after {{ASKED_S.1}} s. No call returns more than {{EARLY_S}} s early, and for the calls with the first robot, the median delay is at most {{LATE_S}} s |
# | 2 | during the first call, the first robot receives a burst of {{BURST_WORDS}} words, and `pump` handles all of them before it returns |
# | 1 | the timers keep firing during the first call: at least {{LEAST_SHARE %}} of the heartbeats are published, with no gap longer than {{LONGEST_SILENCE_S}} s. The robot also looks around at least once |
# | 1 | later calls work, too: the second call handles the {{WAITING_WORDS}} words that arrived after the first call. Callbacks run even in calls of {{ASKED_S.5}} to {{ASKED_S.3}} s |
# | 1 | even with slow jobs in the queue, `pump` returns at most {{LATE_S}} s late. A job that's still running when the time is up may add {{JOB_S}} s |
# | 1 | with the quiet robot, `pump` also returns on time (at most {{EARLY_S}} s early or {{LATE_S}} s late) and handles the robot's first two words |
# | 1 | `pump` uses less than {{PROCESSOR_SHARE %}} of a CPU core with the quiet robot, and less than {{SHARE_WITH_TIMERS %}} with the first robot, which has timers |
# | 1 | between calls, no callback is running, and neither is any thread that `pump` started. The node still has the same timers, periods, subscriptions, guard conditions, and parameters |
#
# **Not judged:** interrupting a running callback, multithreading, callbacks that raise exceptions, and simulated time.
# (`seconds` is measured in real time, and the robots' clocks show real time, too.)
# %% [answer]
"""Spin a node for a given time."""

# [solution]
import time

# [end]
import rclpy
from rclpy.node import Node

# [solution]
TURN_S = 0.05  # s; while the timeout stays the same, the executor runs everything that's ready before it starts over

# [end]

def pump(node: Node, seconds: float) -> None:
    """Run a node's callbacks for a given time, then return.

    Args:
        node: The node to spin. It isn't changed.
        seconds: How long to spin, in seconds of real time.
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
# init()
# watcher = fresh(PumpWatcher)  # asks for pump(robot, 2.0), and sends ten words after a second
# %start
# await run(watcher, seconds=4.0)
# watcher.destroy_node()  # from now on, the exercise's own node asks for pump(robot, 2.0), every 4 s
# print("pump(robot, 2.0) took", "too long" if watcher.took is None else f"{watcher.took:.2f} s")
# picture = strip(watcher.rows, periods={"heartbeats": 0.1}, end=3.0, noun="marks")
# show(picture, "start and end of the call, the heartbeats of the robot, and the words that it handled")
# %% [hint]
# The starter waits for one callback and then returns. How would you do the job by hand? You'd look at the clock, run
# one callback, and look at the clock again. That's a loop. Two questions determine whether the loop is a good one:
# which condition ends it, and how long may each iteration wait at most?
#
# How spinning works: [About executors](https://docs.ros.org/en/jazzy/Concepts/Intermediate/About-Executors.html)
# %% [hint]
# - The loop ends at a point in time, not after a number of iterations. Compute `time.monotonic() + seconds` once,
#   before the loop. `time.monotonic()` is a clock that is never set back.
# - If an iteration may wait longer than the time left, `pump` returns too late when the node is quiet. If an iteration
#   may not wait at all (`timeout_sec=0`), the loop keeps the processor busy.
# - Without a timeout (`timeout_sec=None`), or with a *negative* one, `spin_once` waits forever if nothing becomes
#   ready. So compute the time left once per iteration, and check it before you use it.
# - The node isn't yours, so leave it as it is: no `destroy_node`, no `shutdown`, and no thread that keeps running.
#
# The calls: [rclpy](https://docs.ros.org/en/jazzy/p/rclpy)
# %% [hint]
# The whole function, with gaps to fill in:
#
# ```python
# def pump(node: Node, seconds: float) -> None:
#     end = time.monotonic() + ___
#     while (left := end - ___) > 0:
#         rclpy.spin_once(node, timeout_sec=min(left, ___))
# ```
#
# `:=` assigns a value to a name in the middle of an expression. Without `:=`, compute `left` before the loop and again
# at the end of the loop's body.
#
# How real tests use this: [Writing basic tests with
# Python](https://docs.ros.org/en/jazzy/Tutorials/Intermediate/Testing/Python.html)
# %% [alternatives]
# ## Other good ways
#
# - **Leave out `min`.** `while time.monotonic() < end: rclpy.spin_once(node, timeout_sec=0.05)` is simpler, and it
#   returns late by at most one timeout. Twenty wake-ups a second cost almost nothing. Between two calls, the program
#   can do other work.
# - **Pass `timeout_sec=left`.** This is shorter, avoids needless wake-ups, and gets full credit here. But with a
#   different timeout in each call, the executor starts over with the first timer each time. If that timer's callback
#   takes longer than its period, it runs in every iteration, and messages wait forever. The lesson shows this case.
# - **Call `rclpy.spin_until_future_complete(node, Future(), timeout_sec=seconds)`.** Nothing completes this future, so
#   the timeout ends the spinning. You write only one line, and rclpy runs the loop and watches the time. But readers of
#   your code have to know the trick.
# - **Create a timer that completes a future after `seconds`.** This is elegant if an event ends the spinning anyway.
#   Destroy the timer afterward; otherwise, it keeps firing and ends the next call early.
# - **Use your own `SingleThreadedExecutor`.** `rclpy.spin_once(node)` uses the global executor, and adds and removes
#   the node in each call. With your own executor, you add the node once, which is faster if many callbacks are ready.
#   Also, two calls in two threads don't interfere with each other. At the end, remove the node and shut down the
#   executor, but don't destroy the node.
# - **Don't use a `MultiThreadedExecutor` here.** Its `shutdown` doesn't wait for callbacks that are already running in
#   its threads. A callback that is cut off leaves its callback group locked, and then none of the node's callbacks run
#   anymore.
# - **Spin in another thread, and call `sleep(seconds)` here.** This works if you shut down the executor and join the
#   thread before you return. But more can go wrong, and callbacks run in a thread that the caller doesn't expect.
# - **Use `node.get_clock()` instead of `time.monotonic()`.** Then `seconds` is measured in simulated time, so the call
#   takes half as long in a simulation at double speed. Sometimes that's the right choice, but this task uses real time.
