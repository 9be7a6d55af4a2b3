# loses: returns
# skips: returns_in_time, again, slow_callbacks, quiet_node, easy_on_the_processor, nothing_left_running
# says: `seconds` are seconds
"""Takes seconds for milliseconds."""

import time

import rclpy


def pump(node, seconds):
    end = time.monotonic() + seconds * 1000
    while time.monotonic() < end:
        rclpy.spin_once(node, timeout_sec=0.1)
