# loses: words_handled
# skips: timers_tick, again, slow_callbacks, quiet_node
# says: 0 of 20 words
"""Spins a node, but not the one that was given."""

import time

import rclpy
from rclpy.node import Node


def pump(node, seconds):
    node = Node("pump")
    end = time.monotonic() + seconds
    while (left := end - time.monotonic()) > 0:
        rclpy.spin_once(node, timeout_sec=left)
    node.destroy_node()
