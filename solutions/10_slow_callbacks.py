# ---
# exercise: 10_slow_callbacks
# title: A heart that beats while the arm is planned
# minutes: 30
# difficulty: 3
# kind: program
# clock: wall
# objectives:
#   - give slow work a place where it holds up nobody
#   - let two callbacks of one node run at once, and only those two
#   - keep a result right although several requests come at once
# out_of_scope:
#   - a faster planner; it stays as it is
#   - services and actions, which are made for requests (lesson 12)
#   - what happens after the watch, how the program ends, and how the code is written
# ---
# %% [markdown]
# # Exercise 10 · A heart that beats while the arm is planned
#
# Your humanoid serves tea. Before it stretches its arm, a planner works out how far to bend the elbow, and asks the
# collision checker at every step: 0.8 s for a plan. Meanwhile the safety system listens for a heartbeat, ten times a
# second. When it hears none for half a second, it cuts the power. You see where this leads: every time somebody asks for
# tea, the robot goes limp. Give the planner a place where it does not stop the heart.
#
# **About 30 minutes · difficulty 3 of 5 · 10 points.** You need lesson
# [10](../notebooks/10_slow_callbacks.ipynb).
#
# ## What to build
#
# | topic | direction | type | rate | content |
# |---|---|---|---:|---|
# | `/robot/heartbeat` | published | `String` | 10 Hz | a sign of life, for example `alive` |
# | `/robot/plan_request` | received | `Float32` | | how far from the shoulder the hand shall be, in m |
# | `/robot/plan` | published | `Float32` | | the bend of the elbow for that, in rad |
#
# - Every request is answered by one plan, in the order of the requests. Sometimes four come within half a second. Then
#   they have to wait their turn, but not be forgotten: there is one collision checker, so only one search runs at a time.
# - A distance that was requested before is a new request, and is planned anew. For a distance that the arm cannot
#   reach, the planner finds the straight arm; that is the plan.
# - `ElbowPlanner` is given. **Leave it as it is.** It waits most of its time, it does not keep the processor busy. And it
#   can remember only one search: two at once on one planner spoil each other.
# - Everything else may be changed.
#
# ## What is judged
#
# Your program runs as a process of its own for nine real seconds. The judge sends seven requests in the first four of
# them, and watches what comes back. A plan that has not come after nine seconds is missing.
#
# | points | criterion |
# |---:|---|
# | 1 | `/robot/heartbeat` carries `String` |
# | 2 | 90 % to 110 % of the heartbeats come; typically there are 0.095 to 0.105 s between two (the mean over five) |
# | 2 | never more than 0.5 s without a heartbeat |
# | 1 | the program listens to `/robot/plan_request` and publishes `Float32` on `/robot/plan` |
# | 2 | each plan is what `ElbowPlanner` finds, to 0.000001 rad, and comes 0.78 s after its request, or later |
# | 1 | every request is answered by one plan, in order, one search at a time |
# | 1 | the program is still running at the end of the watch |
#
# **Not part of it:** a faster planner, services, what the text of a heartbeat says, what happens after the nine seconds,
# and how your program ends on Ctrl-C. `ElbowPlanner` is judged by what it finds and by the time that it takes.
# %% [answer]
"""A humanoid that shows its heartbeat, and plans the bend of its elbow when asked."""

import math
import time

import rclpy
# [solution]
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
# [starter]
# | from rclpy.executors import ExternalShutdownException
# [end]
from rclpy.node import Node
from std_msgs.msg import Float32, String

HEARTBEAT_PERIOD_S = 0.1  # 10 Hz
LINK_M = 0.4  # upper arm and forearm are equally long


class ElbowPlanner:
    """Finds the bend of the elbow that brings the hand to a distance from the shoulder. Leave it as it is.

    It halves the range in which the bend must lie, again and again. It remembers one search: begin the next one only
    when the one before is finished.
    """

    STEPS = 20
    STEP_S = 0.04  # the collision checker takes its time

    def begin(self, distance: float) -> None:
        """Begin a search for a distance in m."""
        self._distance = distance
        self._low, self._high = 0.0, math.pi  # rad; 0 is a straight arm

    def step(self) -> None:
        """One step of the search. Waits for the collision checker."""
        time.sleep(self.STEP_S)
        middle = (self._low + self._high) / 2.0
        if 2.0 * LINK_M * math.cos(middle / 2.0) > self._distance:
            self._low = middle
        else:
            self._high = middle

    def bend(self) -> float:
        """The bend found so far, in rad."""
        return (self._low + self._high) / 2.0

    def plan(self, distance: float) -> float:
        """A whole search: returns the bend (rad) for a distance (m), after 0.8 s."""
        self.begin(distance)
        for _ in range(self.STEPS):
            self.step()
        return self.bend()


class TeaRobot(Node):
    """Beats ten times a second, and plans its elbow when asked.

    Topics:
        /robot/heartbeat (std_msgs/String), 10 Hz: "alive".
        /robot/plan (std_msgs/Float32): the bend of the elbow in rad, one for each request.

    Subscriptions:
        /robot/plan_request (std_msgs/Float32): distance of the hand from the shoulder in m.
    """

    def __init__(self) -> None:
        super().__init__("tea_robot")
        self.planner = ElbowPlanner()
        self.heartbeat_publisher = self.create_publisher(String, "/robot/heartbeat", 10)
        self.plan_publisher = self.create_publisher(Float32, "/robot/plan", 10)
        self.create_timer(HEARTBEAT_PERIOD_S, self.beat)
        # [solution]
        # A group of its own: planning may run beside the heartbeat, but never beside another planning.
        planning = MutuallyExclusiveCallbackGroup()
        self.create_subscription(
            Float32, "/robot/plan_request", self.on_request, 10, callback_group=planning
        )
        # [starter]
        # | self.create_subscription(Float32, "/robot/plan_request", self.on_request, 10)
        # [end]

    def beat(self) -> None:
        """Show that the robot is well."""
        self.heartbeat_publisher.publish(String(data="alive"))

    def on_request(self, request: Float32) -> None:
        """Plan the elbow for the distance asked for. This takes 0.8 s."""
        # [solution]
        bend = self.planner.plan(request.data)
        # [starter]
        # | # TODO: while this callback plans, the heart stands still. Give the planning another place.
        # | bend = self.planner.plan(request.data)
        # [end]
        self.plan_publisher.publish(Float32(data=bend))


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or a request to end, then leave with exit code 0."""
    rclpy.init(args=args)
    try:
        # [solution]
        executor = MultiThreadedExecutor(num_threads=2)  # one for the heart, one for the planner
        executor.add_node(TeaRobot())
        executor.spin()
        # [starter]
        # | rclpy.spin(TeaRobot())
        # [end]
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
# %% [live]
# from rclpy.node import Node
# from std_msgs.msg import Float32
#
# from workbook.lesson import fresh, init, run
# from workbook.ros import topic_hz
#
# %start
# init()
# guest = fresh(Node, "guest")
# asking = guest.create_publisher(Float32, "/robot/plan_request", 10)
# await run(guest, seconds=5, until=lambda: asking.get_subscription_count() > 0)
# for distance in (0.7, 0.25, 0.55):
#     asking.publish(Float32(data=distance))
# topic_hz("/robot/heartbeat", seconds=3)
# %% [hint]
# Count on your fingers who needs a thread. The heart needs one for a moment, ten times a second. The planner needs one
# for 0.8 s at a time. How many threads does `rclpy.spin` have? And if there were two: would rclpy be *allowed* to run
# `beat` while `on_request` runs?
#
# Two things are missing, and one of them alone changes nothing.
#
# Who runs callbacks, and how many at once: [About
# executors](https://docs.ros.org/en/jazzy/Concepts/Intermediate/About-Executors.html)
# %% [hint]
# There are two good places for slow work. Choose one.
#
# - **A callback group.** `create_subscription(..., callback_group=MutuallyExclusiveCallbackGroup())` for the slow
#   callback, and a `MultiThreadedExecutor(num_threads=2)` that spins. Not a reentrant group: then a second request
#   would start while the first one is being planned, on the same planner.
# - **A worker.** The callback only puts the distance into a `queue.Queue` and returns. A `threading.Thread` takes one
#   after the other out of it, plans, and publishes. `publish` may be called from any thread.
#
# More on groups: [Using callback groups](https://docs.ros.org/en/jazzy/How-To-Guides/Using-callback-groups.html)
# %% [hint]
# The first way, with gaps:
#
# ```python
# # in __init__
# planning = ___()
# self.create_subscription(Float32, "/robot/plan_request", self.on_request, 10, callback_group=___)
#
# # in main
# executor = ___(num_threads=___)
# executor.add_node(TeaRobot())
# executor.spin()
# ```
#
# Two imports go with it: one from `rclpy.callback_groups`, one from `rclpy.executors`.
#
# What a node and its executors offer: [rclpy](https://docs.ros.org/en/jazzy/p/rclpy)
# %% [alternatives]
# ## Other good ways
#
# - **A worker thread with a queue.** The callback returns at once, and `rclpy.spin` may stay as it is. The queue can hold
#   more than the ten requests of the subscription, and you can look at it: how long is it, is the oldest one still
#   wanted? In return you take care of the thread: its errors, and its end.
# - **`ThreadPoolExecutor(max_workers=1)`.** The same in one line: `self.pool.submit(self.work, request.data)`. With one
#   worker the order is kept. Look at the future that `submit` returns, or errors vanish without a trace.
# - **One step at a time.** A timer calls `planner.step()` and returns; after the last step it publishes. No threads, no
#   locks, and one can stop a search half way. It works because a step takes 0.04 s, less than the period of the heart.
#   Few libraries let you cut their work into steps.
# - **Two processes.** A node for the heart, another for the planner. Nothing in the planner can stop the heart then: not
#   even a crash, or Python code that computes without a pause. For the safety of a real robot, this is the way.
# - **The group for the heartbeat.** It does not matter which of the two gets a group of its own, as long as they are not
#   in the same one.
# - **A reentrant group with a lock.** It works, but who gets a lock next is not defined, so the order of the plans is luck.
#   And each waiting request holds a thread of the executor: with enough of them the heart has none left.
