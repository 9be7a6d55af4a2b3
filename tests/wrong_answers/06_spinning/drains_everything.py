# loses: slow_callbacks
# cause: in-time.callbacks-not-counted
"""Looks at the clock only when nothing is left to do."""

import time

from rclpy.executors import SingleThreadedExecutor, TimeoutException


def pump(node, seconds):
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    end = time.monotonic() + seconds
    while (left := end - time.monotonic()) > 0:
        try:
            handler, _, _ = executor.wait_for_ready_callbacks(timeout_sec=left)
        except TimeoutException:
            break
        handler()
    try:
        while True:
            executor.wait_for_ready_callbacks(timeout_sec=0.03)[0]()
    except TimeoutException:
        pass
    executor.remove_node(node)
    executor.shutdown()
