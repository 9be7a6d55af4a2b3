"""Each spin_once waits for the time that is left."""

import time

import rclpy
from rclpy.node import Node


def pump(node: Node, seconds: float) -> None:
    """Handle the node's callbacks for `seconds` s."""
    deadline = time.monotonic() + seconds
    while True:
        remaining = deadline - time.monotonic()
        if remaining <= 0:
            break
        rclpy.spin_once(node, timeout_sec=remaining)
