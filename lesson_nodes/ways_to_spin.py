"""Spin one node in various ways, correctly or not. Lesson 06 shows each function and runs it with a watchdog.

Run one with ``python -m lesson_nodes.ways_to_spin no_timeout``; numbers after the name are its arguments.
"""

import sys
import threading
import time
from collections.abc import Callable
from pathlib import Path

import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from rclpy.task import Future
from std_msgs.msg import String


def no_timeout(node: Node) -> None:
    """Spin once, without a timeout."""
    print("before")
    rclpy.spin_once(node)
    print("after")


def with_timeout(node: Node, timeout_s: float) -> None:
    """Spin once, with a timeout."""
    print("before")
    rclpy.spin_once(node, timeout_sec=timeout_s)
    print("after")


def busy_s() -> float:
    """Return the time (s) in which this thread ran or waited for a processor. The rest of the time, it slept."""
    ran_ns, waited_ns, _ = Path("/proc/self/schedstat").read_text().split()
    return (int(ran_ns) + int(waited_ns)) / 1e9


def twenty_ticks(node: Node, timeout_s: float) -> None:
    """Spin until a timer has ticked twenty times. Print the iterations, the seconds, and the seconds without sleep."""
    ticks = []
    node.create_timer(0.1, lambda: ticks.append(1))
    iterations, busy, begin = 0, busy_s(), time.monotonic()
    while len(ticks) < 20:
        rclpy.spin_once(node, timeout_sec=timeout_s)
        iterations += 1
    print(iterations, time.monotonic() - begin, busy_s() - busy)


def park_after_round(node: Node) -> None:
    """Finish a round and call shutdown, both in the callback. Park the arm in the line after spin."""

    def finish() -> None:
        print("round finished")
        rclpy.shutdown()

    node.create_timer(0.2, finish)
    rclpy.spin(node)
    print("arm parked")


def park_after_spin(node: Node) -> None:
    """Park the arm in the line after spin."""

    def tick() -> None:
        print("tick")
        timer.cancel()

    timer = node.create_timer(0.2, tick)
    rclpy.spin(node)
    print("arm parked")


def park_in_finally(node: Node) -> None:
    """Park the arm in finally."""

    def tick() -> None:
        print("tick")
        timer.cancel()

    timer = node.create_timer(0.2, tick)
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass
    finally:
        print("arm parked")
        rclpy.try_shutdown()


def wait_in_callback(node: Node) -> None:
    """Wait inside a callback for a map that another callback of the same node delivers."""
    map_is_there: Future = Future()
    node.create_timer(0.3, lambda: map_is_there.done() or map_is_there.set_result("a map"))

    def plan() -> None:
        planner.cancel()
        rclpy.spin_until_future_complete(node, map_is_there, timeout_sec=1.0)
        print("map after 1 s of waiting in the callback:", map_is_there.result())

    planner = node.create_timer(0.1, plan)
    end = time.monotonic() + 2.0
    while time.monotonic() < end:
        rclpy.spin_once(node, timeout_sec=0.1)
    print("map after the callback:", map_is_there.result())


def go_on_later(node: Node) -> None:
    """Register in the callback what to do when the map arrives, and return."""
    map_is_there: Future = Future()
    node.create_timer(0.3, lambda: map_is_there.done() or map_is_there.set_result("a map"))

    def plan() -> None:
        planner.cancel()
        map_is_there.add_done_callback(lambda future: print("planning with", future.result()))

    planner = node.create_timer(0.1, plan)
    rclpy.spin_until_future_complete(node, map_is_there)
    rclpy.spin_once(node, timeout_sec=0.1)


def rate_without_spin(node: Node) -> None:
    """Sleep with a rate in the only thread."""
    rate = node.create_rate(10)
    for _ in range(5):
        print("step")
        rate.sleep()


def two_spins(node: Node) -> None:
    """Spin two nodes in two threads, both with the global executor."""
    other = Node("other")
    ticks = {"robot": 0, "other": 0}

    def count(name: str) -> None:
        ticks[name] += 1

    node.create_timer(0.1, lambda: count("robot"))
    other.create_timer(0.1, lambda: count("other"))
    first = threading.Thread(target=rclpy.spin, args=(node,), name="spin 1")
    second = threading.Thread(target=rclpy.spin, args=(other,), name="spin 2")
    first.start()
    time.sleep(0.5)
    second.start()
    time.sleep(0.5)
    before = dict(ticks)
    time.sleep(0.5)
    print("still ticking:", *[name for name in ticks if ticks[name] > before[name]])
    rclpy.shutdown()


def one_executor(node: Node) -> None:
    """Spin two nodes in one thread, with one executor."""
    other = Node("other")
    ticks = {"robot": 0, "other": 0}

    def count(name: str) -> None:
        ticks[name] += 1

    node.create_timer(0.1, lambda: count("robot"))
    other.create_timer(0.1, lambda: count("other"))
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    executor.add_node(other)
    while min(ticks.values()) < 5:
        executor.spin_once(timeout_sec=0.1)
    print("ticking:", *ticks)


def thread_left_behind(node: Node) -> None:
    """Return while another thread is still spinning."""
    node.create_timer(0.05, lambda: None)
    threading.Thread(target=rclpy.spin, args=(node,), daemon=True).start()
    time.sleep(0.5)
    print("the work is done")


def thread_ended(node: Node) -> None:
    """Shut down the executor, then wait for the spinning thread to end."""
    node.create_timer(0.05, lambda: None)
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    thread = threading.Thread(target=executor.spin)
    thread.start()
    time.sleep(0.5)
    print("the work is done")
    executor.shutdown()  # makes spin return
    thread.join()  # waits until it has returned
    rclpy.shutdown()


def busy_timer(node: Node, slice_s: float) -> None:
    """Spin for 2 s with a timer that is always due. `slice_s` is the timeout (s); 0 means all of the remaining time."""
    heard: list[str] = []
    node.create_timer(0.01, lambda: time.sleep(0.02))

    def hear(message: String) -> None:
        heard.append(message.data)

    node.create_subscription(String, "/robot/words", hear, 10)
    publisher = node.create_publisher(String, "/robot/words", 10)
    while publisher.get_subscription_count() == 0:
        time.sleep(0.01)
    for word in ("stop", "wait", "turn", "wave", "walk"):
        publisher.publish(String(data=word))
    time.sleep(0.2)  # by now, the words have arrived, and the timer is overdue
    end = time.monotonic() + 2.0
    while (left := end - time.monotonic()) > 0:
        rclpy.spin_once(node, timeout_sec=slice_s or left)
    print("heard:", len(heard), "of 5")


WAYS: dict[str, Callable[..., None]] = {
    way.__name__: way
    for way in (
        no_timeout, with_timeout, twenty_ticks, park_after_round, park_after_spin, park_in_finally,
        wait_in_callback, go_on_later, rate_without_spin, two_spins, one_executor, thread_left_behind,
        thread_ended, busy_timer,
    )
}  # fmt: skip

if __name__ == "__main__":
    rclpy.init()
    WAYS[sys.argv[1]](Node("robot"), *map(float, sys.argv[2:]))
