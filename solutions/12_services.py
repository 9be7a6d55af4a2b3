# ---
# exercise: 12_services
# title: A self-test every second
# minutes: 25
# difficulty: 3
# kind: program
# clock: wall
# objectives:
#   - call a service from a timer without holding up the node
#   - report each answer as soon as it comes, and only once
#   - give up on a call that is not answered, and continue with the next
# out_of_scope:
#   - offering a service; another program offers the self-test
#   - waiting until the service is there; it already is
#   - how the program ends (lesson 01 judges that) and how the code is written
# ---
# %% [markdown]
# # Exercise 12 · A self-test every second
#
# The humanoid can test itself. When its service `/robot/self_test` is called, it moves each joint a little and reports
# whether all is well. Usually the answer comes at once. Sometimes it takes a while. And sometimes the motor controller
# restarts at the wrong moment, and no answer ever comes. You write the node that calls the service once a second and
# reports the result to the control room. The control room also needs a heartbeat from your node, five times a second,
# and switches the robot off when the heartbeat stops. So whatever happens to a call, the heartbeat must continue.
#
# **About 25 minutes · difficulty 3 of 5 · 10 points.** You need lesson
# [12](../notebooks/12_services.ipynb).
#
# ## What to build
#
# | name | type | what |
# |---|---|---|
# | `/robot/self_test` | service, `std_srvs/srv/Trigger` | your node calls it once a second |
# | `/robot/health` | topic, `String` | one message for each call: `ok`, `faulty` or `no answer` |
# | `/robot/heartbeat` | topic, `String` | 5 Hz, whatever happens; any text. It is given |
#
# - Publish `ok` when the field `success` of the response is true, `faulty` when it is not. (The text in `message` is
#   for people, and the same text may come with both.) Report each answer when it comes, at most 0.8 s later, and only
#   once. Report it even when it is the same as the one before.
# - An answer may take 0.8 s. If it has not come one second after the call, it will never come. Then publish
#   `no answer`, once for each such call: no earlier than 0.8 s and no later than 2 s after the call. Then continue with
#   the next calls. (While you wait for an answer, you may skip one call.)
#
# ## What is judged
#
# Your program runs as its own process for twelve and a half real seconds. The judge offers the service: it answers some
# calls at once, some after 0.7 s, and some never.
#
# | points | criterion |
# |---:|---|
# | 1 | the program is still running when the judge stops watching |
# | 1 | calls of `/robot/self_test` arrive, again and again |
# | 1 | they come once a second, even after a call without an answer |
# | 1 | `/robot/health` exists, carries `String`, and says only the three words |
# | 2 | each answer is reported: right, in time and once |
# | 2 | `no answer` is reported in time, and only for calls that got no answer |
# | 2 | the heartbeat comes at 5 Hz, even while a call waits for its answer |
#
# These tolerances allow for busy machines. Once a second means typically 0.9 to 1.1 s from one call to the next. At
# most one pause is over 1.4 s, and none reaches 2.5 s. One exception: after a call without an answer, each pause may be
# up to 2.5 s. In all, there is at most one call for every 0.9 s (rounded, and not counting the first). A report may be
# 0.1 s later than stated above, and one of them 0.8 s later. A `no answer` may be 0.3 s later, or 0.1 s earlier. Where
# every `no answer` is early, 0.03 s is the limit. 5 Hz means 90 % to 110 % of the beats, typically one every 0.18 to
# 0.22 s. The last one comes at most 0.9 s before the end. While calls are open, 60 % of the beats are enough.
#
# The program may have any form: callbacks, `await`, threads, several nodes.
#
# **Not part of it:** offering a service, waiting for the service to appear, and what the text of a heartbeat says.
# How your program ends on Ctrl-C is not judged either. Nor is a `no answer` in the first 2.5 s: it may belong to a call
# that was sent before the judge was connected.
# %% [answer]
"""Calls the self-test of the robot once a second, and reports the result to the control room."""

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
    """Asks for a self-test again and again, and reports each result.

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
        """Say that this node lives."""
        self.heartbeat_publisher.publish(String(data="alive"))

    # [solution]
    def ask(self) -> None:
        """Give up the last call if it is still open, then send the next request. Does not wait."""
        if self.open_call is not None:
            self.self_test.remove_pending_request(self.open_call)
            self.report("no answer")
        self.open_call = self.self_test.call_async(Trigger.Request())
        self.open_call.add_done_callback(self.on_answer)

    def on_answer(self, future: Future) -> None:
        """Report the result, unless this call has been given up."""
        if future is not self.open_call:
            return
        self.open_call = None
        self.report("ok" if future.result().success else "faulty")

    def report(self, health: str) -> None:
        """Report to the control room."""
        self.health_publisher.publish(String(data=health))

    # [starter]
    # | # TODO 4: the method that your timer calls. It sends the request, and returns at once.
    # | # TODO 5: what runs when the answer comes? And what notices that there is none?
    # |
    # [end]


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or a request to end, then leave with exit code 0."""
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
# from lesson_nodes import self_test_server
# from workbook.lesson import start
# from workbook.ros import topic_echo
#
# start(self_test_server, pattern="ok,faulty,slow,never,ok")
# %start
# # When your node publishes: topic_echo("/robot/health", count=5, timeout=10)
# %% [hint]
# The heartbeat and the request share one thread. So the method that sends the request must not wait: not with `call()`,
# not in a loop, not in a spin. It sends the request and returns. Something else must run when the answer comes.
#
# What about an answer that never comes? Nothing calls your code for it. But one method of your node already runs once a
# second. What could it check?
#
# Services and clients: [About services](https://docs.ros.org/en/jazzy/Concepts/Basic/About-Services.html)
# %% [hint]
# - `future = self.self_test.call_async(Trigger.Request())` sends the request and gives you a future at once.
# - `future.add_done_callback(self.on_answer)`: rclpy calls `self.on_answer(future)` when the answer is there. Its
#   `future.result()` is the response, with the fields `success` and `message`.
# - Store the future in an attribute. If that future is still open when the timer fires again, its time is up.
# - A call that you have given up on should not call you back later: `self.self_test.remove_pending_request(future)`.
#
# Why not simply `call()`: [Synchronous vs. asynchronous service
# clients](https://docs.ros.org/en/jazzy/How-To-Guides/Sync-Vs-Async.html)
# %% [hint]
# The two methods, with gaps:
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
# - **`await` in a callback of its own group.** `response = await self.self_test.call_async(...)` reads in order, from
#   request to response. The client needs a different callback group from the callback that waits, and the heartbeat
#   must not be in that group either. `await` has no timeout: a second timer must `cancel()` the future, or the method
#   waits forever.
# - **`call(request, timeout_sec=0.9)` with threads.** This is the shortest code: it waits, and returns `None` when
#   nothing came. It needs a thread that only waits, a `MultiThreadedExecutor`, and the right callback groups for timer,
#   client and heartbeat. In your own thread, outside all callbacks, it is simpler still.
# - **Look at the future from time to time.** The heartbeat runs five times a second and can check `future.done()`. This
#   needs no done callback and no group, but an answer may be reported up to 0.2 s later.
# - **Several calls open at a time.** With a dictionary from future to the time of the call, you can send the next
#   request while an old one is still open. You need this when answers may take longer than the period. Then think about
#   the order: an old answer may come after a new one.
# - **`spin_until_future_complete` in the callback.** Do not do this. In the default group it never gets the answer.
#   With its own group it gets the answer, but it spins the node a second time from inside. It takes the node away from
#   its executor, and then nothing spins the node.
# - **A topic instead.** If the robot published its health once a second, no requests would be needed, and any number of
#   nodes could subscribe. Use a service when the work is done only on request.
