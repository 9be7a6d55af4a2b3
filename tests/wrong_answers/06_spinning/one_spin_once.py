# loses: returns_in_time, words_handled, timers_tick, slow_callbacks, quiet_node
# skips: again
# cause: in-time.too-early
"""One spin_once: "process everything for that long"."""

import rclpy
from rclpy.node import Node


def pump(node: Node, seconds: float) -> None:
    rclpy.spin_once(node, timeout_sec=seconds)
