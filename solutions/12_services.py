# ---
# exercise: 12_services
# title: A self-test every second
# minutes: 25
# difficulty: 3
# kind: program
# clock: wall
# objectives:
#   - calling a service from a timer without blocking the node
#   - reporting each response as soon as it arrives, and only once
#   - giving up on a request that gets no response, and continuing with the next one
# out_of_scope:
#   - offering a service; another program offers the self-test
#   - waiting until the service is available; it already is
#   - how the program ends (lesson 01 judges that) and how the code is written
# ---
# %% [markdown]
# # Exercise 12 · A self-test every second
#
# The humanoid can test itself: when its service `/robot/self_test` is called, the robot moves each joint a little and
# responds with the result. Usually, the response arrives right away, but sometimes it takes a while. And if the motor
# controller restarts at the wrong moment, there's no response at all. Write a node that calls the service once a second
# and reports each result to the control room. The control room also expects a heartbeat from your node five times a
# second, and it switches the robot off if the heartbeat stops. So the heartbeat must continue, no matter how a call
# turns out.
#
# **About 25 minutes · difficulty 3 of 5 · 10 points.** This exercise builds on lesson [12](../notebooks/12_services.ipynb).
#
# ## What to build
#
# | name | type | use |
# |---|---|---|
# | `/robot/self_test` | service, `std_srvs/srv/Trigger` | your node calls it once a second |
# | `/robot/health` | topic, `String` | your node publishes one message for each call: `ok`, `faulty`, or `no answer` |
# | `/robot/heartbeat` | topic, `String` | your node publishes a message at 5 Hz, whatever happens (any text will do); the starter code already does this |
#
# - When a response arrives, publish `ok` if its `success` field is true, and `faulty` otherwise. (Don't rely on the
#   `message` field: it's meant for people, and the same text may come with either result.) Report each response only
#   once, and at most {{TOLD_WITHIN_S}} s after it arrives. Report it even if the result is the same as the previous
#   one.
# - A response may take up to {{MAY_TAKE_S}} s. For each call without a response, publish `no answer` once, no earlier
#   than {{MAY_TAKE_S}} s and no later than {{GIVEN_UP_WITHIN_S}} s after the call. Waiting for one second is a safe
#   choice, because a response that hasn't arrived by then never will. After a `no answer`, keep calling the service.
#   (While you're waiting for a response, you may skip the next scheduled call.)
#
# ## What is judged
#
# Your program runs in its own process for twelve and a half seconds of real time. The judge offers the service. It
# responds to some calls right away, to others after {{SLOW}} s, and to others not at all.
#
# | points | criterion |
# |---:|---|
# | 1 | the program is still running at the end |
# | 1 | calls to `/robot/self_test` keep arriving |
# | 1 | there is one call per second, even after a call without a response |
# | 1 | `/robot/health` exists, has the type `String`, and carries only the three words |
# | 2 | each response is reported correctly, on time, and only once |
# | 2 | `no answer` is reported on time, and only for calls that got no response |
# | 2 | the heartbeat is published at 5 Hz, even while your node is waiting for a response |
#
# To allow for busy machines, the judge applies these tolerances:
#
# - **Once a second** means that the median interval between calls is {{SHORTEST_PERIOD_S}} to {{LONGEST_PERIOD_S}} s.
#   All intervals must be shorter than {{LONGEST_PAUSE_S}} s, and at most one may be longer than {{PAUSE_S}} s. But
#   intervals that follow a call without a response are exempt from the {{PAUSE_S}} s limit. The number of calls is
#   limited, too. Divide the time from the first call to the last by {{SHORTEST_PERIOD_S}} s, and round the result to
#   the nearest integer. That integer is the maximum number of calls after the first one.
# - **A report** may be up to {{SLACK_S}} s later than stated above, and one report may be up to {{LATER_ONCE_S}} s
#   later. A `no answer` may come up to {{LONG_SLACK_S}} s later than stated above, or up to {{SLACK_S}} s earlier. The
#   {{SLACK_S}} s margin is meant for an occasional early report. But if every `no answer` is more than {{NEARLY_S}} s
#   early, the judge counts that as an error.
# - **5 Hz** means that the number of beats is {{LEAST_SHARE %}} to {{MOST_SHARE %}} of the expected number. The median
#   interval between beats must be {{SHORTEST_BEAT_S}} to {{LONGEST_BEAT_S}} s, and the final beat must arrive in the
#   last {{STOPPED_S}} s of the run. While your node is waiting for a response, {{LEAST_MEANWHILE %}} of the expected
#   beats are enough.
#
# You may structure the program any way you like: with callbacks, `await`, threads, or several nodes.
#
# **Not judged:** offering a service, waiting until the service is available, the text of a heartbeat, and how your
# program ends on Ctrl-C. A `no answer` in the first {{FIRST_SECONDS_S}} s isn't judged either, because it may refer to
# a call made before the judge was connected.
# %% [answer]
"""Call the robot's self-test once a second, and report each result to the control room."""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
# [solution]
from rclpy.task import Future
# [end]
from std_msgs.msg import String
# [solution]
from std_srvs.srv import Trigger
# [end]

HEARTBEAT_PERIOD_S = 0.2  # 5 Hz
# [solution]
ASK_PERIOD_S = 1.0
# [end]


class HealthMonitor(Node):
    """Requests a self-test once a second, and reports each result.

    Topics:
        /robot/heartbeat (std_msgs/String), 5 Hz: "alive".
        /robot/health (std_msgs/String): "ok", "faulty" or "no answer", once for each call.

    Calls:
        /robot/self_test (std_srvs/Trigger), once a second.
    """

    def __init__(self) -> None:
        super().__init__("health_monitor")
        self.heartbeat_publisher = self.create_publisher(String, "/robot/heartbeat", 10)
        self.create_timer(HEARTBEAT_PERIOD_S, self.beat)
        # [solution]
        self.health_publisher = self.create_publisher(String, "/robot/health", 10)
        self.self_test = self.create_client(Trigger, "/robot/self_test")
        self.open_call: Future | None = None
        self.create_timer(ASK_PERIOD_S, self.ask)
        # [starter]
        # | # TODO 1: a publisher for /robot/health
        # | # TODO 2: a client for the service /robot/self_test (type Trigger, from std_srvs.srv)
        # | # TODO 3: a timer that calls the service once a second
        # [end]

    def beat(self) -> None:
        """Publish a sign of life."""
        self.heartbeat_publisher.publish(String(data="alive"))

    # [solution]
    def ask(self) -> None:
        """Give up on the last call if it's still open, then send the next request. Don't wait for the response."""
        if self.open_call is not None:
            self.self_test.remove_pending_request(self.open_call)
            self.report("no answer")
        self.open_call = self.self_test.call_async(Trigger.Request())
        self.open_call.add_done_callback(self.on_answer)

    def on_answer(self, future: Future) -> None:
        """Report the result, unless we've given up on this call."""
        if future is not self.open_call:
            return
        self.open_call = None
        self.report("ok" if future.result().success else "faulty")

    def report(self, health: str) -> None:
        """Report to the control room."""
        self.health_publisher.publish(String(data=health))

    # [starter]
    # | # TODO 4: the method that your timer calls. It sends the request and returns right away.
    # | # TODO 5: which method runs when the response arrives? And which one notices that none has arrived?
    # |
    # [end]


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(HealthMonitor())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
# %% [live]
# from workbook.ros import topic_echo
#
# %start
# # When your node publishes: topic_echo("/robot/health", count=5, timeout=10)
# %% [hint]
# The heartbeat and the requests share one thread. So the method that sends a request must not wait: not in `call()`,
# not in a loop, and not in a spin function. It sends the request and returns. Other code must run when the response
# arrives.
#
# And if no response ever arrives? Then rclpy calls none of your methods for it. But one method of your node already
# runs once a second. What could it check?
#
# Services and clients: [About services](https://docs.ros.org/en/jazzy/Concepts/Basic/About-Services.html)
# %% [hint]
# - `future = self.self_test.call_async(Trigger.Request())` sends the request and returns a future right away.
# - After `future.add_done_callback(self.on_answer)`, rclpy calls `self.on_answer(future)` when the response has
#   arrived. `future.result()` is then the response, with the fields `success` and `message`.
# - Store the future in an attribute. If it's still there when the timer fires again, the call has run out of time.
# - After you've given up on a call, a late response to it should no longer trigger your method. To prevent that, use
#   `self.self_test.remove_pending_request(future)`.
#
# Why you can't simply use `call()`: [Synchronous vs. asynchronous service
# clients](https://docs.ros.org/en/jazzy/How-To-Guides/Sync-Vs-Async.html)
# %% [hint]
# Here are the two methods with gaps:
#
# ```python
# def ask(self) -> None:
#     if self.open_call is not None:  # called a second ago, and still open
#         self.self_test.___(self.open_call)
#         self.health_publisher.publish(String(data=___))
#     self.open_call = self.self_test.___(Trigger.Request())
#     self.open_call.___(self.on_answer)
#
# def on_answer(self, future) -> None:
#     self.open_call = ___
#     self.health_publisher.publish(String(data="ok" if ___ else "faulty"))
# ```
#
# A client, step by step: [Writing a simple service and
# client](https://docs.ros.org/en/jazzy/Tutorials/Beginner-Client-Libraries/Writing-A-Simple-Py-Service-And-Client.html)
# %% [alternatives]
# ## Other good ways
#
# - **`await` in a callback with its own group.** With `response = await self.self_test.call_async(...)`, the code reads
#   in order, from request to response. The client needs a different callback group than the callback that waits, and
#   the heartbeat must not be in that callback's group either. `await` has no timeout, so a second timer must `cancel()`
#   the future, or the method waits forever.
# - **`call(request, timeout_sec=0.9)` with threads.** This is the shortest code: `call` waits, and it returns `None` if
#   no response arrives in time. It occupies a thread while it waits. So it needs a `MultiThreadedExecutor` and the
#   right callback groups for the timer, the client, and the heartbeat. In your own thread, outside of all
#   callbacks, it's simpler still.
# - **Check the future regularly.** The heartbeat's callback runs five times a second, so it can check `future.done()`.
#   You need no done callback and no group, but you may report a response up to 0.2 s late.
# - **Several open calls.** Store each future with the time of its call in a dictionary. Then you can send the next
#   request while an older one is still open. You need this when responses may take longer than the period. Consider the
#   order, because the response to an older request may arrive after a newer one.
# - **`spin_until_future_complete` in the callback.** Don't do this. In the default group, the client never receives the
#   response. In a separate group, it does. But this function removes the node from its executor, and after that,
#   nothing spins the node.
# - **A topic instead.** If the robot published its health once a second, you'd need no requests, and any number of
#   nodes could subscribe. Use a service when the work is to be done only on request.
