# ---
# exercise: 12_services
# title: A question every second
# minutes: 25
# difficulty: 3
# kind: program
# clock: wall
# objectives:
#   - call a service from a timer without holding up the node
#   - report each answer when it comes, and once
#   - give up a call that is not answered, and go on asking
# out_of_scope:
#   - offering a service; the self-test is offered by somebody else
#   - waiting until the service is there; it is
#   - how the program ends (lesson 01 judges that) and how the code is written
# ---
# %% [markdown]
# # Exercise 12 · A question every second
#
# The humanoid can test itself. Ask its service `/robot/self_test`, and it moves each joint a little and says whether all
# is well. Most of the time the answer is there at once. Sometimes it takes a while. And now and then the motor
# controller restarts at the wrong moment, and no answer comes, ever. You write the node that asks once a second and
# tells the control room what came out. The control room also wants a heartbeat from it, five times a second, and pulls
# the plug of the robot when the heart stops. So whatever happens to a call: the heart goes on.
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
# | `/robot/heartbeat` | topic, `String` | 5 Hz, whatever happens; any text. It is there already |
#
# - `ok` when the field `success` of the response is true, `faulty` when it is not. (The text in `message` is for people,
#   and the same text may come with both.) Report each answer when it comes, at the latest 0.8 s after it, and once, also
#   when it says the same as the one before.
# - An answer may take 0.8 s. One that is not there a second after the call will not come any more. Say `no answer` then,
#   once for each such call: no earlier than 0.8 s and no later than 2 s after the call. Then go on asking. (While you
#   wait for an answer, you may leave out one question.)
#
# ## What is judged
#
# Your program runs as a process of its own for ten real seconds. The judge offers the service: it answers some calls
# at once, some after 0.7 s, and some never.
#
# | points | criterion |
# |---:|---|
# | 1 | the program is still running at the end of the watch |
# | 1 | calls of `/robot/self_test` arrive, again and again |
# | 1 | they come once a second, also after a call without an answer |
# | 1 | `/robot/health` exists, carries `String`, and says only the three words |
# | 2 | each answer is told: right, in time and once |
# | 2 | `no answer` is told in time, and only where there was none |
# | 2 | the heartbeat comes at 5 Hz, also while a call waits for its answer |
#
# What a busy machine may cost: once a second means typically 0.9 to 1.1 s from one call to the next, with no more than
# one pause over 1.4 s, and never 2.5 s; only after a call without an answer, each pause may be up to 2.5 s. A report may
# be 0.1 s later than said above (one of them 0.8 s), a `no answer` 0.1 s earlier or 0.3 s later. 5 Hz means 90 % to 110 %
# of the beats, typically one every 0.18 to 0.22 s, no silence over 0.9 s at the end, and 60 % of the beats while calls
# are open.
#
# Any shape of program will do: callbacks, `await`, threads, several nodes.
#
# **Not part of it:** offering a service, waiting for the service to appear, what the text of a heartbeat says, and how
# your program ends on Ctrl-C.
# %% [answer]
"""Asks the robot once a second to test itself, and tells the control room what came out."""

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
        # | # TODO 3: a timer that asks once a second
        # [end]

    def beat(self) -> None:
        """Say that this node lives."""
        self.heartbeat_publisher.publish(String(data="alive"))

    # [solution]
    def ask(self) -> None:
        """Give up the call of a second ago if it is still open, then send the next one. Waits for nothing."""
        if self.open_call is not None:
            self.self_test.remove_pending_request(self.open_call)
            self.report("no answer")
        self.open_call = self.self_test.call_async(Trigger.Request())
        self.open_call.add_done_callback(self.on_answer)

    def on_answer(self, future: Future) -> None:
        """Report the result, unless this call has been given up meanwhile."""
        if future is not self.open_call:
            return
        self.open_call = None
        self.report("ok" if future.result().success else "faulty")

    def report(self, health: str) -> None:
        """Tell the control room."""
        self.health_publisher.publish(String(data=health))

    # [starter]
    # | # TODO 4: the method that your timer calls. It sends the request, and returns at once.
    # | # TODO 5: who hears of the answer? And who notices that there is none?
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
# The heartbeat and the question share one thread. So the method that asks must not wait: not with `call()`, not with a
# loop, not with a spin. It sends the request and returns. Something else has to happen when the answer comes.
#
# And the answer that never comes? Nothing will call you for it. But something in your node comes by once a second
# anyway. What could it look at?
#
# Services and clients: [About services](https://docs.ros.org/en/jazzy/Concepts/Basic/About-Services.html)
# %% [hint]
# - `future = self.self_test.call_async(Trigger.Request())` sends the request and gives you a future at once.
# - `future.add_done_callback(self.on_answer)`: rclpy calls `self.on_answer(future)` when the answer is there. Its
#   `future.result()` is the response, with the fields `success` and `message`.
# - Keep the future in an attribute. When the timer comes round again and that future is still open, its time is up.
# - A call that you give up should not come back: `self.self_test.remove_pending_request(future)`.
#
# Why not simply `call()`: [Synchronous vs. asynchronous service
# clients](https://docs.ros.org/en/jazzy/How-To-Guides/Sync-Vs-Async.html)
# %% [hint]
# The two methods, with gaps:
#
# ```python
# def ask(self) -> None:
#     if self.open_call is not None:  # asked a second ago, and still open
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
# - **`await` in a callback of its own group.** `response = await self.self_test.call_async(...)` reads like a story, from
#   question to answer. The client needs another callback group than the callback that waits, and the heartbeat must not
#   be in the waiting one's group either. And `await` has no time-out: a second timer has to `cancel()` the future, or
#   the method waits for the rest of its life.
# - **`call(request, timeout_sec=0.9)` with threads.** Shortest to write: it waits, and says `None` when nothing came. It
#   costs a thread that does nothing but wait, a `MultiThreadedExecutor`, and three groups thought through: that of the
#   timer, that of the client, that of the heartbeat. In a thread of your own, outside all callbacks, it is simpler still.
# - **Look at the future from time to time.** The heartbeat comes by five times a second and can ask `future.done()`. No
#   callback, no group; the price is up to 0.2 s until the answer is told.
# - **Several calls open at a time.** A dictionary from future to the moment of the call lets the next question go out
#   while an old one is still open. Needed when answers may take longer than the period. Then think about the
#   order: an old answer may come after a new one.
# - **`spin_until_future_complete` in the callback.** Do not. In the default group it always waits in vain. With a group of
#   its own it gets the answer, but it spins the node a second time from inside, and a node that another executor had
#   before belongs to nobody afterwards.
# - **A topic instead.** If the robot published its health once a second, nobody would have to ask, and any number of
#   listeners could hear it. Ask when the work is done only because somebody asks.
