# ---
# exercise: 10_slow_callbacks
# title: A heartbeat that continues while the robot plans
# minutes: 30
# difficulty: 3
# kind: program
# clock: wall
# objectives:
#   - running slow code where it doesn't delay other callbacks
#   - keeping the heartbeat going during a search, without ever running two searches at the same time
#   - keeping results correct when several requests arrive at the same time
# out_of_scope:
#   - a faster planner; do not change it
#   - services and actions, which are designed for requests (lesson 12)
#   - what happens after the nine seconds, how the program ends, and how the code is written
# ---
# %% [markdown]
# # Exercise 10 · A heartbeat that continues while the robot plans
#
# Your humanoid serves tea. Before the robot reaches out, a planner works out how far to bend the elbow. The planner
# searches step by step, and each step queries the collision checker, so one plan takes {{PLANNING_S}} s. But the safety
# system expects a heartbeat ten times a second, and if none arrives for half a second, it cuts the power. So whenever a
# guest asks for tea, the robot goes limp. Change the program so that planning no longer stops the heartbeat.
#
# **About 30 minutes · difficulty 3 of 5 · 10 points.** This exercise builds on lesson [10](../notebooks/10_slow_callbacks.ipynb).
#
# ## What to build
#
# | topic | direction | type | rate | content |
# |---|---|---|---:|---|
# | `/robot/heartbeat` | published | `String` | 10 Hz | a sign of life, for example `alive` |
# | `/robot/plan_request` | received | `Float32` | | the requested distance from the shoulder to the hand, in m |
# | `/robot/plan` | published | `Float32` | | the elbow's bend for the requested distance, in rad |
#
# - Publish one plan for every request, in the order in which the requests arrive. Sometimes, four requests arrive
#   within half a second. There's only one collision checker, so only one search may run at a time, and the other
#   requests have to wait. But you must not lose any of them.
# - If the same distance is requested again, treat that as a new request, and run the planner again. If a distance is
#   beyond the arm's reach, the planner returns almost 0 rad, which means a straight arm. Publish that plan, too.
# - We provide `ElbowPlanner`. **Don't change it.** It spends most of its time waiting, so it doesn't keep the processor
#   busy. A planner object stores the state of only one search: if two searches run at the same time, they overwrite
#   each other's state.
# - You may change anything else.
#
# ## What is judged
#
# Your program runs in its own process for nine seconds of real time. The judge sends seven requests in the first four
# seconds and records the plans that your program publishes. A plan that hasn't arrived after nine seconds counts as
# missing.
#
# | points | criterion |
# |---:|---|
# | 1 | `/robot/heartbeat` carries `String` messages |
# | 2 | even while the robot is planning, heartbeats keep coming: their number is {{LEAST_SHARE %}} to {{MOST_SHARE %}} of the expected number. The median interval, averaged over five consecutive intervals, is {{TYPICALLY_S.0}} to {{TYPICALLY_S.1}} s |
# | 2 | the heartbeat never pauses for more than {{LONGEST_SILENCE_S}} s |
# | 1 | the program subscribes to `/robot/plan_request` and publishes `Float32` messages on `/robot/plan` |
# | 2 | each plan matches `ElbowPlanner`'s result to within {{TOLERANCE_RAD}} rad and is published at least {{SOONEST_S}} s after its request |
# | 1 | there is one plan for every request, the plans are in the same order as the requests, and only one search runs at a time |
# | 1 | the program is still running at the end |
#
# **Not judged:** the use of services (see lesson 12), a heartbeat's text, anything after the nine seconds, and how your
# program ends on Ctrl-C. The judge can't see whether you changed `ElbowPlanner`. It sees only the planner's results and
# how long they take.
# %% [answer]
"""Publish a humanoid's heartbeat, and plan its elbow's bend on request."""

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
    """Finds the elbow's bend that brings the hand to a distance from the shoulder. Don't change this class.

    Each step halves the range in which the bend must lie. A planner holds one search: begin the next one only when the
    previous one has finished.
    """

    STEPS = 20
    STEP_S = 0.04  # the collision checker takes its time

    def begin(self, distance: float) -> None:
        """Begin a search for a distance in m."""
        self._distance = distance
        self._low, self._high = 0.0, math.pi  # rad; 0 is a straight arm

    def step(self) -> None:
        """Do one step of the search. This waits for the collision checker."""
        time.sleep(self.STEP_S)
        middle = (self._low + self._high) / 2.0
        if 2.0 * LINK_M * math.cos(middle / 2.0) > self._distance:
            self._low = middle
        else:
            self._high = middle

    def bend(self) -> float:
        """Return the bend found so far, in rad."""
        return (self._low + self._high) / 2.0

    def plan(self, distance: float) -> float:
        """Do a whole search: return the bend (rad) for a distance (m), after 0.8 s."""
        self.begin(distance)
        for _ in range(self.STEPS):
            self.step()
        return self.bend()


class TeaRobot(Node):
    """Publishes ten heartbeats a second, and plans the elbow's bend on request.

    Topics:
        /robot/heartbeat (std_msgs/String), 10 Hz: "alive".
        /robot/plan (std_msgs/Float32): the elbow's bend in rad, one for each request.

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
        # A separate group: planning may run while the heartbeat does, but two plans never run at the same time.
        planning = MutuallyExclusiveCallbackGroup()
        self.create_subscription(
            Float32, "/robot/plan_request", self.on_request, 10, callback_group=planning
        )
        # [starter]
        # | self.create_subscription(Float32, "/robot/plan_request", self.on_request, 10)
        # [end]

    def beat(self) -> None:
        """Publish a sign of life."""
        self.heartbeat_publisher.publish(String(data="alive"))

    def on_request(self, request: Float32) -> None:
        """Plan the elbow's bend for the requested distance. This takes 0.8 s."""
        # [solution]
        bend = self.planner.plan(request.data)
        # [starter]
        # | # TODO: while this callback plans, the heartbeat stops. Run the planning elsewhere.
        # | bend = self.planner.plan(request.data)
        # [end]
        self.plan_publisher.publish(Float32(data=bend))


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or SIGTERM, then exit with code 0."""
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
# init()
# guest = fresh(Node, "guest")  # while it's in the graph, the exercise's own guest pauses
# asking = guest.create_publisher(Float32, "/robot/plan_request", 10)
# %start
# await run(guest, seconds=5, until=lambda: asking.get_subscription_count() > 0)
# for distance in (0.7, 0.25, 0.55):
#     asking.publish(Float32(data=distance))
# rate = topic_hz("/robot/heartbeat", seconds=3)
# guest.destroy_node()
# rate
# %% [hint]
# Count the callbacks that need a thread. The heartbeat needs one for a moment, ten times a second. The planner needs
# one for 0.8 s at a time. How many threads does `rclpy.spin` use? And if there were two, would rclpy be *allowed* to
# run `beat` while `on_request` runs?
#
# Your program lacks two things, and neither of them helps without the other.
#
# How callbacks run, and how many at the same time: [About
# executors](https://docs.ros.org/en/jazzy/Concepts/Intermediate/About-Executors.html)
# %% [hint]
# There are two good places for slow work. Choose one.
#
# - **A callback group.** Pass `callback_group=MutuallyExclusiveCallbackGroup()` to `create_subscription` for the slow
#   callback. Then spin the node with a `MultiThreadedExecutor(num_threads=2)`. Don't use a reentrant group, because a
#   second search would start on the same planner while the first one is still running.
# - **A worker.** The callback only puts the distance into a `queue.Queue` and returns. A `threading.Thread` takes one
#   distance after another from the queue, plans, and publishes. You may call `publish` from any thread.
#
# More on groups: [Using callback groups](https://docs.ros.org/en/jazzy/How-To-Guides/Using-callback-groups.html)
# %% [hint]
# Here's the first way with gaps:
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
# - **A worker thread with a queue.** The callback returns right away, so you can keep `rclpy.spin`. The queue can hold
#   more requests than the subscription's ten, and you can check its length. You can also check whether the oldest
#   request is still wanted. But you have to handle the thread's exceptions and end the thread yourself.
# - **`ThreadPoolExecutor(max_workers=1)`.** This is the same idea in one line: `self.pool.submit(self.work,
#   request.data)`. With a single worker, the plans stay in order. Check the future that `submit` returns, or errors are
#   lost silently.
# - **One step at a time.** A timer callback calls `planner.step()` and returns. After the last step, it publishes the
#   plan. You need no threads and no locks, and you can stop a search halfway. This works because a step takes 0.04 s,
#   less than the heartbeat's period. But few libraries let you split their work into steps.
# - **Two processes.** Use one node for the heartbeat and another for the planner, each in its own process. Then nothing
#   in the planner can stop the heartbeat: not even a crash, or Python code that computes without a pause. For a real
#   robot's safety, this is the right way.
# - **A separate group for the heartbeat.** Either callback can get its own group, as long as the two aren't in the same
#   group.
# - **A reentrant group with a lock.** This works, but the order in which threads get a lock isn't defined. So the order
#   of the plans is left to chance. Each waiting request also occupies a thread of the executor. With enough waiting
#   requests, no thread is left for the heartbeat.
