"""Short waits, and a look at the clock after each."""

from time import perf_counter

import rclpy


def pump(node, seconds):
    started = perf_counter()
    while rclpy.ok() and perf_counter() - started < seconds:
        rclpy.spin_once(node, timeout_sec=0.02)
