# ---
# exercise: 11_polling_against_callbacks
# title: A monitor that doesn't poll
# minutes: 20
# difficulty: 2
# kind: program
# clock: wall
# objectives:
#   - recognizing polling in a program that almost works
#   - handling each message in a callback, as soon as it arrives
#   - letting `rclpy.spin` do the waiting
# out_of_scope:
#   - what happens after a touch has been reported
#   - messages that get lost between programs (lesson 13)
#   - how the program ends, and how the code is written
# ---
# %% [markdown]
# # Exercise 11 · A monitor that doesn't poll
#
# Your humanoid's hand is holding an egg. The hand is covered with a touch-sensitive skin that assigns a number to each
# touch. A monitor is supposed to forward every number to the grip controller, which must loosen the grip before the egg
# breaks. But some numbers never reach the grip controller, and others reach it only after the shell has cracked. You
# open the program and find a loop that polls: five times a second, it checks which touch arrived last. Rewrite the
# program so that it doesn't poll.
#
# **About 20 minutes · difficulty 2 of 5 · 10 points.** This exercise builds on lesson
# [11](../notebooks/11_polling_against_callbacks.ipynb).
#
# ## What to build
#
# | topic | direction | type | content |
# |---|---|---|---|
# | `/robot/touch` | received | `Int32` | the number of a touch, such as 7 |
# | `/monitor/seen` | published | `Int32` | the number of each touch, published once, as soon as the touch arrives |
#
# Touches can arrive one at a time or in bursts of about a dozen, and sometimes none arrive for several seconds. The
# skin started counting long before your monitor started. It sometimes skips a number, and it starts over at 1 whenever
# it's switched on. So the same number can arrive again for a new touch. Report each touch that arrives, and nothing
# else.
#
# ## What is judged
#
# Your program runs in its own process for nine seconds. The judge publishes 60 touches, with one pause of three
# seconds. It records which reports your program publishes, and when.
#
# | points | criterion |
# |---:|---|
# | 1 | the program subscribes to `/robot/touch` and publishes on `/monitor/seen`, both with the type `Int32` |
# | 3 | no touch is missed |
# | 2 | no touch is reported twice, and the reports are in the order of the touches |
# | 2 | at least three quarters of the touches that arrive alone are reported within {{ALONE_MS}} ms. At least half of those that arrive together are reported within {{TOGETHER_MS}} ms |
# | 1 | while no touches arrive, the program uses less than {{PROCESSOR_SHARE %}} of one CPU core |
# | 1 | the program is still running at the end of the run |
#
# **Not judged:** the grip controller, messages lost on the way to your program, pauses longer than three seconds, and
# how your program ends on Ctrl-C. DDS needs a moment to match your publisher with the judge's subscription. Reports
# that your program publishes before then don't reach the judge, so they aren't judged. The judge also can't tell a
# callback from a loop that polls a hundred times a second. Remove the polling anyway.
# %% [answer]
"""Report each touch of the hand."""

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
        /monitor/seen (std_msgs/Int32): the touch's number.

    Subscriptions:
        /robot/touch (std_msgs/Int32): the touch's number.
    """

    def __init__(self) -> None:
        super().__init__("touch_monitor")
        self.seen_publisher = self.create_publisher(Int32, "/monitor/seen", 100)
        # [solution]
        self.create_subscription(Int32, "/robot/touch", self.on_touch, 100)
        # [starter]
        # | self.create_subscription(Int32, "/robot/touch", self.on_touch, 100)
        # | self.last = 0  # the touch that arrived last
        # | self.reported = 0  # the touch that was reported last
        # [end]

    # [solution]
    def on_touch(self, touch: Int32) -> None:
        """Report the touch as soon as it arrives."""
        self.seen_publisher.publish(Int32(data=touch.data))
    # [starter]
    # | def on_touch(self, touch: Int32) -> None:
    # |     """Store the touch until the loop checks it."""
    # |     self.last = touch.data
    # |
    # | def look(self) -> None:
    # |     """Report the last touch if it's new."""
    # |     if self.last != self.reported:
    # |         self.reported = self.last
    # |         self.seen_publisher.publish(Int32(data=self.reported))
    # [end]


# [solution]
def main(args: list[str] | None = None) -> None:
    """Run the monitor until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(TouchMonitor())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()
# [starter]
# | def receive(monitor: TouchMonitor) -> None:
# |     """Spin the monitor in a second thread, so that it receives touches while the loop runs."""
# |     try:
# |         rclpy.spin(monitor)
# |     except ExternalShutdownException:
# |         pass
# |
# |
# | def main(args: list[str] | None = None) -> None:
# |     """Poll until Ctrl-C or SIGTERM, then exit with code 0."""
# |     rclpy.init(args=args)
# |     monitor = TouchMonitor()
# |     receiving = threading.Thread(target=receive, args=(monitor,))
# |     receiving.start()
# |     try:
# |         while rclpy.ok():  # TODO: don't poll
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
# init()
# seen = []
# hand = fresh(Node, "hand")  # while it's in the graph, the robot's own skin pauses
# hand.create_subscription(Int32, "/monitor/seen", lambda report: seen.append(report.data), 100)
# touching = hand.create_publisher(Int32, "/robot/touch", 100)
# %start
# await run(hand, seconds=5, until=lambda: touching.get_subscription_count() > 0)
# for number in range(1, 11):
#     touching.publish(Int32(data=number))
# await run(hand, seconds=1)
# hand.destroy_node()
# print("touches 1 to 10, seen:", seen)
# %% [hint]
# Follow one touch through the program. When it arrives, rclpy calls `on_touch` right away, once for each touch. So far,
# so good. What does `on_touch` do with the touch? Which function reports it, and when? Everything that goes wrong
# happens between these two functions.
#
# What a subscription does when a message arrives: [About
# topics](https://docs.ros.org/en/jazzy/Concepts/Basic/About-Topics.html)
# %% [hint]
# - `on_touch` receives the message, and it may publish, too: `self.seen_publisher.publish(...)` works in any callback.
# - Then you no longer need `last`, `reported`, `look`, or the loop in `main`.
# - Without the loop, the main thread can spin the node itself, so one thread is enough.
# - Keep the queue depth of 100, because about a dozen touches may be waiting at the same time.
#
# What a node offers: [rclpy](https://docs.ros.org/en/jazzy/p/rclpy)
# %% [hint]
# Here's the rest of the program with gaps:
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
# - **`self.create_subscription(Int32, "/robot/touch", self.seen_publisher.publish, 100)`.** The publisher's own method
#   is the callback, so each message is forwarded unchanged. This is short, and it's right as long as the message needs
#   no processing.
# - **A queue and a worker thread.** `on_touch` puts the number into a `queue.Queue`, and a thread that waits in `get()`
#   reports it. This isn't polling: `get()` sleeps until the queue has an item. It's right when reporting takes long
#   (lesson 10), but you don't need it for a single `publish`.
# - **A loop around `spin_once(timeout_sec=1.0)`.** `spin_once` waits for messages, so this loop reacts fast and uses no
#   CPU time while it waits. `rclpy.spin` is the same kind of loop.
# - **A condition variable.** You can keep the starter code's loop if it waits in `condition.wait()` instead of `sleep`,
#   and the callback notifies it. With a list of all touches, it misses none. But there's little to gain, and much that
#   can go wrong.
# - **A faster loop.** It reports sooner and uses more CPU time, but it still misses touches that arrive together. No
#   sleep is short enough.
