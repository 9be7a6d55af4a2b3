# loses: returns
# skips: returns_in_time, again, slow_callbacks, quiet_node, easy_on_the_processor, nothing_left_running
# says: rclpy.spin and executor.spin know no end
"""Spins, and means to look at the clock afterwards."""

import time

import rclpy


def pump(node, seconds):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        rclpy.spin(node)
