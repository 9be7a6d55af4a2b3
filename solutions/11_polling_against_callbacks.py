# ---
# exercise: 11_polling_against_callbacks
# title: A monitor that does not poll
# minutes: 20
# difficulty: 2
# kind: program
# clock: wall
# objectives:
#   - recognize polling in a program that almost works
#   - let a callback act on each message when it comes
#   - let spin do the waiting
# out_of_scope:
#   - what happens after a touch was reported
#   - messages that are lost between programs (lesson 13)
#   - how the program ends, and how the code is written
# ---
# %% [markdown]
# # Exercise 11 · A monitor that does not poll
#
# The hand of your humanoid has a skin that feels touches and numbers them. A monitor passes each number on to the grip
# control, which must let go before the egg breaks. But the log shows missing numbers, and some touches reach the grip
# control after the shell has cracked. You open the program, and find a loop that polls: it looks at the last touch five
# times a second. Change the program so that it does not poll.
#
# **About 20 minutes · difficulty 2 of 5 · 10 points.** You need lesson
# [11](../notebooks/11_polling_against_callbacks.ipynb).
#
# ## What to build
#
# | topic | direction | type | content |
# |---|---|---|---|
# | `/robot/touch` | received | `Int32` | the number of a touch, such as 7 |
# | `/monitor/seen` | published | `Int32` | the same number, for each touch, once, at once |
#
# Touches may come alone, or a dozen at once, and then none for some seconds. The skin began to count long before your
# monitor started. It sometimes skips a number, and starts again at 1 each time it is switched on. So a number may come
# again, and is a new touch then. Report what comes, and nothing else.
#
# ## What is judged
#
# Your program runs as its own process for nine seconds. The judge sends 60 touches and records what comes back, and
# when. For three seconds it sends none.
#
# | points | criterion |
# |---:|---|
# | 1 | it subscribes to `/robot/touch` and reports on `/monitor/seen`, both `Int32` |
# | 3 | no touch is missed |
# | 2 | no touch is reported twice, and all are reported in order |
# | 2 | of the touches that come alone, three in four are reported within 10 ms; of those that come together, half within 200 ms |
# | 1 | while no touch comes, the program uses less than 5 % of a processor |
# | 1 | the program is still running when the judge stops watching |
#
# **Not part of it:** what the grip control does, lost messages, longer pauses than three seconds, and how your program
# ends on Ctrl-C. When your program starts, the judge does not see a report that is published before its subscription is
# connected. It also cannot see whether a loop polls a hundred times a second or a callback is called, but you should
# remove the polling.
# %% [answer]
"""A monitor that reports each touch of the hand."""

# [solution]
import rclpy
# [starter]
# | import threading
# | import time
# |
# | import rclpy
# [end]
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Int32


class TouchMonitor(Node):
    """Reports each touch of the hand.

    Topics:
        /monitor/seen (std_msgs/Int32): the number of the touch.

    Subscriptions:
        /robot/touch (std_msgs/Int32): the number of the touch.
    """

    def __init__(self) -> None:
        super().__init__("touch_monitor")
        self.seen_publisher = self.create_publisher(Int32, "/monitor/seen", 100)
        # [solution]
        self.create_subscription(Int32, "/robot/touch", self.on_touch, 100)
        # [starter]
        # | self.create_subscription(Int32, "/robot/touch", self.on_touch, 100)
        # | self.last = 0  # the touch that came last
        # | self.reported = 0  # the touch that was reported last
        # [end]

    # [solution]
    def on_touch(self, touch: Int32) -> None:
        """Report the touch, as soon as it comes."""
        self.seen_publisher.publish(Int32(data=touch.data))
    # [starter]
    # | def on_touch(self, touch: Int32) -> None:
    # |     """Keep the touch until the loop looks at it."""
    # |     self.last = touch.data
    # |
    # | def look(self) -> None:
    # |     """Report the last touch, if it is a new one."""
    # |     if self.last != self.reported:
    # |         self.reported = self.last
    # |         self.seen_publisher.publish(Int32(data=self.reported))
    # [end]


# [solution]
def main(args: list[str] | None = None) -> None:
    """Run the monitor until Ctrl-C or a request to end, then leave with exit code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(TouchMonitor())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()
# [starter]
# | def receive(monitor: TouchMonitor) -> None:
# |     """Let the monitor receive, in a thread beside the loop."""
# |     try:
# |         rclpy.spin(monitor)
# |     except ExternalShutdownException:
# |         pass
# |
# |
# | def main(args: list[str] | None = None) -> None:
# |     """Poll until Ctrl-C or a request to end, then leave with exit code 0."""
# |     rclpy.init(args=args)
# |     monitor = TouchMonitor()
# |     receiving = threading.Thread(target=receive, args=(monitor,))
# |     receiving.start()
# |     try:
# |         while rclpy.ok():  # TODO: do not poll
# |             monitor.look()
# |             time.sleep(0.2)
# |     except KeyboardInterrupt:
# |         pass
# |     finally:
# |         rclpy.try_shutdown()
# |         receiving.join()
# [end]


if __name__ == "__main__":
    main()
# %% [live]
# from rclpy.node import Node
# from std_msgs.msg import Int32
#
# from workbook.lesson import fresh, init, run
#
# %start
# init()
# seen = []
# hand = fresh(Node, "hand")
# hand.create_subscription(Int32, "/monitor/seen", lambda report: seen.append(report.data), 100)
# touching = hand.create_publisher(Int32, "/robot/touch", 100)
# await run(hand, seconds=5, until=lambda: touching.get_subscription_count() > 0)
# for number in range(1, 11):
#     touching.publish(Int32(data=number))
# await run(hand, seconds=1)
# print("touches 1 to 10, seen:", seen)
# %% [hint]
# Follow one touch through the program. It arrives, and `on_touch` is called at once, for each touch. So far all is
# well. What does `on_touch` do with it? Which function reports it, and when? Everything that goes wrong goes wrong
# between these two.
#
# What a subscription does when a message comes: [About
# topics](https://docs.ros.org/en/jazzy/Concepts/Basic/About-Topics.html)
# %% [hint]
# - `on_touch` gets the message. It can publish: `self.seen_publisher.publish(...)` works in any callback.
# - Then you no longer need `last`, `reported` and `look`, or the loop in `main`.
# - Without the loop, the main thread can do what the other thread does. Then you need only one thread.
# - Keep the depth of 100: a dozen touches may wait at the same time.
#
# What a node offers: [rclpy](https://docs.ros.org/en/jazzy/p/rclpy)
# %% [hint]
# The rest of the program, with gaps:
#
# ```python
#     def on_touch(self, touch: Int32) -> None:
#         self.seen_publisher.publish(Int32(data=___))
#
#
# def main(args: list[str] | None = None) -> None:
#     rclpy.init(args=args)
#     try:
#         rclpy.___(TouchMonitor())
#     except (KeyboardInterrupt, ExternalShutdownException):
#         pass
#     finally:
#         rclpy.try_shutdown()
# ```
#
# A subscriber, step by step: [Writing a simple publisher and
# subscriber](https://docs.ros.org/en/jazzy/Tutorials/Beginner-Client-Libraries/Writing-A-Simple-Py-Publisher-And-Subscriber.html)
# %% [alternatives]
# ## Other good ways
#
# - **`self.create_subscription(Int32, "/robot/touch", self.seen_publisher.publish, 100)`.** The message is passed on
#   unchanged, without a method in between. This is short, and right as long as nothing has to be done with the message.
# - **A queue and a worker thread.** `on_touch` puts the number into a `queue.Queue`, and a thread that waits in `get()`
#   reports it. `get()` does not poll either: it sleeps until something is there. This is right when reporting takes
#   long (lesson 10). For one `publish` it is not needed.
# - **A loop around `spin_once(timeout_sec=1.0)`.** `spin_once` waits inside, so this is quick and uses no processor
#   time. `rclpy.spin` is the same loop.
# - **A condition variable.** You can keep the loop of the starter: let it wait in `condition.wait()` instead of
#   `sleep`, and let the callback notify it. With a list of all touches it misses nothing. But much can go wrong, for
#   little gain.
# - **A faster loop.** It is quicker and uses more processor time, but it still misses touches that come together. No
#   sleep is short enough.
