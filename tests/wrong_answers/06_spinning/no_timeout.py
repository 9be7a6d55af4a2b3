# loses: quiet_node
# says: spin_once without a timeout waits until there is something to do
"""Works as long as the node is busy."""

import time

import rclpy


def pump(node, seconds):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        rclpy.spin_once(node)
