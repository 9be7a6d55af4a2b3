# loses: again
# skips: slow_callbacks, quiet_node
# says: Leave the node and the context as you found them
"""Ends ROS after the first call, as every main() does."""

import time

import rclpy


def pump(node, seconds):
    end = time.monotonic() + seconds
    while (left := end - time.monotonic()) > 0:
        rclpy.spin_once(node, timeout_sec=left)
    rclpy.shutdown()
