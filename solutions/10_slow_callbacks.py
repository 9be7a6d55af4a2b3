# ---
# exercise: 10_slow_callbacks
# title: A heart that beats while the robot plans
# minutes: 30
# difficulty: 3
# kind: program
# clock: wall
# objectives:
#   - run slow work where it holds up nothing else
#   - let two callbacks of one node run at the same time, and only those two
#   - keep results right when several requests come at once
# out_of_scope:
#   - a faster planner; do not change it
#   - services and actions, which are made for requests (lesson 12)
#   - what happens after the nine seconds, how the program ends, and how the code is written
# ---
# %% [markdown]
# # Exercise 10 · A heart that beats while the robot plans
#
# Your humanoid serves tea. Before it stretches its arm, a planner computes how far to bend the elbow, and asks the
# collision checker at every step. One plan takes 0.8 s. Meanwhile the safety system expects a heartbeat ten times a
# second. When none comes for half a second, it cuts the power. So every time a guest asks for tea, the robot goes limp.
# Run the planner where it does not stop the heartbeat.
#
# **About 30 minutes · difficulty 3 of 5 · 10 points.** You need lesson
# [10](../notebooks/10_slow_callbacks.ipynb).
#
# ## What to build
#
# | topic | direction | type | rate | content |
# |---|---|---|---:|---|
# | `/robot/heartbeat` | published | `String` | 10 Hz | a sign of life, for example `alive` |
# | `/robot/plan_request` | received | `Float32` | | wanted distance from the shoulder to the hand, in m |
# | `/robot/plan` | published | `Float32` | | the bend of the elbow for this distance, in rad |
#
# - Every request is answered by one plan, in the order of the requests. Sometimes four requests come within half a
#   second. Then they must wait their turn, but none may be lost. There is one collision checker, so only one search
#   runs at a time.
# - A distance that was requested before is a new request, and is planned again. For a distance that the arm cannot
#   reach, the planner finds the straight arm; that is the plan.
# - `ElbowPlanner` is given. **Leave it as it is.** It waits most of the time and does not keep the processor busy. It
#   can hold only one search: two searches at once on one planner overwrite each other.
# - You may change everything else.
#
# ## What is judged
#
# Your program runs as its own process for nine real seconds. The judge sends seven requests in the first four seconds,
# and watches what comes back. A plan that has not come after nine seconds is missing.
#
# | points | criterion |
# |---:|---|
# | 1 | `/robot/heartbeat` carries `String` |
# | 2 | 90 % to 110 % of the heartbeats come; typically there are 0.095 to 0.105 s between two (the mean over five), while plans are made, too |
# | 2 | never more than 0.5 s without a heartbeat |
# | 1 | the program subscribes to `/robot/plan_request` and publishes `Float32` on `/robot/plan` |
# | 2 | each plan is what `ElbowPlanner` finds, to 0.000001 rad, and comes 0.78 s after its request, or later |
# | 1 | every request is answered by one plan, in order, one search at a time |
# | 1 | the program is still running when the judge stops watching |
#
# **Not part of it:** a faster planner, services, and what the text of a heartbeat says. What happens after the nine
# seconds, and how your program ends on Ctrl-C, are not judged either. `ElbowPlanner` is judged by what it finds and
# how long it takes.
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
        # A group of its own: planning may run beside the heartbeat, but never two plans at once.
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
        # | # TODO: while this callback plans, the heartbeat stops. Run the planning elsewhere.
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
# Count what needs a thread. The heartbeat needs one for a moment, ten times a second. The planner needs one for 0.8 s
# at a time. How many threads does `rclpy.spin` have? And if there were two: would rclpy be *allowed* to run `beat`
# while `on_request` runs?
#
# Two things are missing, and each of them alone changes nothing.
#
# How callbacks run, and how many at once: [About
# executors](https://docs.ros.org/en/jazzy/Concepts/Intermediate/About-Executors.html)
# %% [hint]
# There are two good places for slow work. Choose one.
#
# - **A callback group.** `create_subscription(..., callback_group=MutuallyExclusiveCallbackGroup())` for the slow
#   callback, and a `MultiThreadedExecutor(num_threads=2)` that spins. Do not use a reentrant group: a second search
#   would then start on the same planner while the first one still runs.
# - **A worker.** The callback only puts the distance into a `queue.Queue` and returns. A `threading.Thread` takes one
#   distance after another out of it, plans, and publishes. `publish` may be called from any thread.
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
# You also need two imports: one from `rclpy.callback_groups`, one from `rclpy.executors`.
#
# What a node and its executors offer: [rclpy](https://docs.ros.org/en/jazzy/p/rclpy)
# %% [alternatives]
# ## Other good ways
#
# - **A worker thread with a queue.** The callback returns at once, and `rclpy.spin` may stay as it is. The queue can
#   hold more than the ten requests of the subscription, and you can check how long it is. You can also check whether
#   the oldest request is still wanted. But you must take care of the thread: its errors, and its end.
# - **`ThreadPoolExecutor(max_workers=1)`.** The same in one line: `self.pool.submit(self.work, request.data)`. With one
#   worker the order is kept. Check the future that `submit` returns, or errors are lost silently.
# - **One step at a time.** A timer calls `planner.step()` and returns; after the last step it publishes. There are no
#   threads and no locks, and you can stop a search halfway. It works because a step takes 0.04 s, less than the period
#   of the heartbeat. Few libraries let you split their work into steps.
# - **Two processes.** Use one node for the heartbeat and another for the planner. Then nothing in the planner can stop
#   the heartbeat: not even a crash, or Python code that computes without a pause. This is the right way for the safety
#   of a real robot.
# - **The group for the heartbeat.** It does not matter which of the two gets its own group, as long as they are not in
#   the same group.
# - **A reentrant group with a lock.** This works, but the order in which threads get a lock is not defined, so the
#   order of the plans is left to chance. Each waiting request also holds a thread of the executor. With enough of them,
#   none is left for the heartbeat.
