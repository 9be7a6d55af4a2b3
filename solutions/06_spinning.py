# ---
# exercise: 06_spinning
# title: A pump for callbacks
# minutes: 25
# difficulty: 3
# kind: function
# clock: wall
# objectives:
#   - let a node work for a given time, and come back when it is up
#   - give every wait a timeout, and know which one
#   - wait without burning the processor
#   - leave a node as you found it
# out_of_scope:
#   - interrupting a callback that is running already
#   - running callbacks side by side, in several threads (lesson 10)
#   - exceptions that a callback raises
# ---
# %% [markdown]
# # Exercise 06 · A pump for callbacks
#
# Your humanoid stands in a test bench. The bench is an ordinary Python program: it moves an arm, lets the robot live
# for a second and a half, reads a gauge, lets it live for another second. `rclpy.spin` is of no use to it, because it
# does not come back. What the bench needs is a pump: *let this node work for so many seconds, then give me back the
# program.*
#
# **About 25 minutes · difficulty 3 of 5 · 10 points.** You need lesson [06](../notebooks/06_spinning.ipynb).
#
# ## What to build
#
# One function, `pump(node, seconds)`. It makes no node and does not call `rclpy.init`: the bench does both.
#
# | | what pump does |
# |---|---|
# | while the time runs | runs every callback of `node` that is ready: timers and subscriptions |
# | when the time is up | comes back: not earlier, and at most one callback later |
# | as long as nothing is ready | waits, and leaves the processor to others |
# | afterwards | nothing of it goes on; the node is as it was and can be pumped again |
#
# ## What is judged
#
# A driver imports your file and calls `pump` seven times, for 0.05 s to 2.1 s. Its robot has a heartbeat (10 Hz), looks
# around (2 Hz), repeats each word that it hears, and has slow jobs of 0.4 s. A second robot is quiet: it has no timer,
# and hears two words towards the end. Both tell on topics what they do, and the driver announces when each call begins
# and ends, and what it has changed on the node.
#
# | points | criterion |
# |---:|---|
# | 1 | `pump` comes back |
# | 1 | after 2.1 s when it was asked for 2.1 s: at most 0.05 s earlier, at most 0.25 s later in the median of its calls |
# | 2 | each of the 20 words that come in a burst is handled while it pumps |
# | 1 | the timers go on at their rate meanwhile: 80 % of the heartbeats or more, no silence over 0.3 s |
# | 1 | a second call does it again, and handles the words that waited in the queue |
# | 1 | a queue of slow jobs does not carry it far beyond its time: at most one job (0.4 s) and 0.25 s |
# | 1 | it comes back in time (0.25 s) from the quiet robot, too |
# | 1 | it takes less than 12 % of a processor while the robot is quiet |
# | 1 | between two calls nothing goes on, and the node has the timers and subscriptions that it had |
#
# **Not part of it:** stopping a callback that runs already, several threads, callbacks that raise, simulated time (seconds
# are real time, and so is the clock of the two robots).
# %% [answer]
"""Lets a node work for a given time."""

# [solution]
import time

# [end]
import rclpy
from rclpy.node import Node

# [solution]
TURN_S = 0.05  # the same timeout in each turn lets the executor serve all that is ready before it begins again

# [end]

def pump(node: Node, seconds: float) -> None:
    """Run the callbacks of a node for some time, then come back.

    Args:
        node: The node that shall work. It is left as it is.
        seconds: How long, in seconds of real time.
    """
    # [solution]
    end = time.monotonic() + seconds
    while (left := end - time.monotonic()) > 0:
        rclpy.spin_once(node, timeout_sec=min(left, TURN_S))
    # [starter]
    # | # TODO 1: note the moment at which the time is up
    # | # TODO 2: go on until that moment, and never wait longer than is left of the time
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
# watcher = fresh(PumpWatcher)  # orders pump(robot, 2.0), and says ten words after a second
# await run(watcher, seconds=4.0)
# print("pump(robot, 2.0) took", "too long" if watcher.took is None else f"{watcher.took:.2f} s")
# picture = strip(watcher.rows, periods={"heartbeats": 0.1}, end=3.0, noun="marks")
# show(picture, "begin and end of the call, the heartbeats of the robot, and the words that it handled")
# %% [hint]
# The starter waits for one callback and is done with it. What would you do by hand? Look at the clock, let the robot
# do one thing, look at the clock again. That is a loop. Two questions decide whether it is a good one: what ends it,
# and how long may each turn wait at most?
#
# What spinning is: [About executors](https://docs.ros.org/en/jazzy/Concepts/Intermediate/About-Executors.html)
# %% [hint]
# - The end is a moment, not a number of turns: `time.monotonic() + seconds`, worked out once, before the loop.
#   `time.monotonic()` is a clock that nobody sets back.
# - A turn that may wait longer than is left comes back too late from a quiet node. A turn that may not wait at all
#   (`timeout_sec=0`) keeps the processor busy.
# - `timeout_sec=None`, none at all, or a *negative* one waits forever. So work out what is left once, and look at it
#   before you use it.
# - You were handed the node, so leave it: no `destroy_node`, no `shutdown`, no thread that goes on.
#
# The calls: [rclpy](https://docs.ros.org/en/jazzy/p/rclpy)
# %% [hint]
# The whole function, with gaps:
#
# ```python
# def pump(node: Node, seconds: float) -> None:
#     end = time.monotonic() + ___
#     while (left := end - ___) > 0:
#         rclpy.spin_once(node, timeout_sec=___)
# ```
#
# `:=` gives a value a name in the middle of an expression. Without it, work out `left` before the loop and again at the
# end of its body.
#
# Where this is used for real, in tests: [Writing basic tests with
# Python](https://docs.ros.org/en/jazzy/Tutorials/Intermediate/Testing/Python.html)
# %% [alternatives]
# ## Other good ways
#
# - **Slices without `min`.** `while time.monotonic() < end: rclpy.spin_once(node, timeout_sec=0.05)`. Simpler, and late
#   by a slice at most. Twenty wake-ups a second cost next to nothing, and between two slices the program can do something
#   else.
# - **`timeout_sec=left`.** Shorter, no needless wake-up, and full marks here. But with another timeout each time the
#   executor begins each turn anew, with the first timer. One that takes longer than its period then gets every turn, and
#   messages wait for good. The lesson shows it.
# - **`rclpy.spin_until_future_complete(node, Future(), timeout_sec=seconds)`.** Nobody completes this future, so the
#   timeout ends it. One line, and the loop with the clock is rclpy's. But the reader has to know the trick.
# - **A timer that completes a future after `seconds`.** Elegant when the end is an event anyway. Destroy the timer
#   afterwards, or it goes on ticking and ends the next call early.
# - **A `SingleThreadedExecutor` of your own.** `rclpy.spin_once(node)` borrows the global executor and adds and removes
#   the node each time. With your own you add it once, which is faster when there is a lot to do, and two pumps in two
#   threads do not get in each other's way. Remove the node and shut the executor down at the end; the node lives on.
# - **A `MultiThreadedExecutor`.** Better not for this. Its `shutdown` does not wait for callbacks that it has handed to
#   its threads, and one that is cut off leaves its callback group locked: the node is deaf from then on.
# - **Another thread that spins, and `sleep(seconds)` here.** Works if you shut the executor down and join the thread
#   before you come back. More to get wrong, and callbacks run in a thread that the caller does not expect.
# - **`node.get_clock()` instead of `time.monotonic()`.** Then `seconds` are robot time, and a simulation that runs at
#   double speed is pumped for half as long. Sometimes this is what you want. Here it was real time.
