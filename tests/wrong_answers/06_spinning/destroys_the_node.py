# loses: again, slow_callbacks, nothing_left_running
# cause: again.does-nothing
"""Cleans up what it did not make."""

import time

from rclpy.executors import SingleThreadedExecutor


def pump(node, seconds):
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    end = time.monotonic() + seconds
    while (left := end - time.monotonic()) > 0:
        executor.spin_once(timeout_sec=left)
    executor.shutdown()
    node.destroy_node()
