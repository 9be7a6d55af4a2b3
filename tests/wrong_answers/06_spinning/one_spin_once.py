# loses: returns_in_time, words_handled
# skips: timers_tick, again, slow_callbacks, quiet_node
# says: Callbacks were counted, and not time
"""One spin_once: "process everything for that long"."""

import rclpy
from rclpy.node import Node


def pump(node: Node, seconds: float) -> None:
    rclpy.spin_once(node, timeout_sec=seconds)
