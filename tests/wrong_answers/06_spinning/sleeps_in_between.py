# loses: words_handled
# skips: timers_tick, again, slow_callbacks, quiet_node
# says: One spin_once runs one callback
"""Ten looks a second at what has come, so as not to burn the processor."""

import time

import rclpy


def pump(node, seconds):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        rclpy.spin_once(node, timeout_sec=0)
        time.sleep(0.08)
