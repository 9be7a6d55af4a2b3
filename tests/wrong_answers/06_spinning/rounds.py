# loses: timers_tick
# says: never sleep in between
"""Twice a second it handles all that is there, and sleeps in between."""

import time

import rclpy


def pump(node, seconds):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        for _ in range(30):
            if time.monotonic() < end:
                rclpy.spin_once(node, timeout_sec=0)
        time.sleep(max(0.0, min(0.5, end - time.monotonic())))
