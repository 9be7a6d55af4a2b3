# loses: again
# skips: slow_callbacks, quiet_node
# says: its executor or ROS itself was gone
"""Shuts down the executor that rclpy.spin_once uses for everybody."""

import time

import rclpy


def pump(node, seconds):
    end = time.monotonic() + seconds
    while (left := end - time.monotonic()) > 0:
        rclpy.spin_once(node, timeout_sec=left)
    rclpy.get_global_executor().shutdown()
