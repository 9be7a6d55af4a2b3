# loses: program_runs
# skips: returns, returns_in_time, words_handled, timers_tick, again, slow_callbacks, quiet_node, easy_on_the_processor, nothing_left_running
# skips: easy_on_the_processor, nothing_left_running
# cause: pump.missing
"""A program that does it for its own node."""

import time

import rclpy
from rclpy.node import Node


def main():
    rclpy.init()
    node = Node("own")
    end = time.monotonic() + 1.0
    while time.monotonic() < end:
        rclpy.spin_once(node, timeout_sec=0.1)
    rclpy.try_shutdown()


if __name__ == "__main__":
    main()
