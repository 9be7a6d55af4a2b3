# loses: returns_in_time, words_handled
# skips: timers_tick, again, slow_callbacks, quiet_node
# says: Callbacks were counted, and not time
"""Ten turns of a tenth of a second make a second."""

import rclpy


def pump(node, seconds):
    for _ in range(int(seconds / 0.1)):
        rclpy.spin_once(node, timeout_sec=0.1)
