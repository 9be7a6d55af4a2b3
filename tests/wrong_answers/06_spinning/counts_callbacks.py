# loses: returns_in_time, words_handled, timers_tick, slow_callbacks, quiet_node
# skips: again
# cause: in-time.too-early
"""Two turns of half a second make a second."""

import rclpy


def pump(node, seconds):
    for _ in range(max(1, round(seconds / 0.5))):
        rclpy.spin_once(node, timeout_sec=0.5)
