# loses: quiet_node
# says: Before each spin_once, work out how much time is left
"""Each wait may be as long as the whole call."""

import time

import rclpy


def pump(node, seconds):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        rclpy.spin_once(node, timeout_sec=seconds)
