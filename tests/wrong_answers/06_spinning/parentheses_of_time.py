# loses: program_runs
# skips: returns, returns_in_time, words_handled, timers_tick, again, slow_callbacks, quiet_node
# skips: easy_on_the_processor, nothing_left_running
# says: pump raised TypeError
# says: line 14
"""`time.monotonic` without its parentheses is a function and no number."""

import time

import rclpy


def pump(node, seconds):
    end = time.monotonic + seconds
    while time.monotonic() < end:
        rclpy.spin_once(node, timeout_sec=0.1)
