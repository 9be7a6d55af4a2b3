# loses: again, slow_callbacks, nothing_left_running
# also: quiet_node
# cause: again.handled-before
"""A thread does the work. It is a daemon, so nobody has to end it."""

import threading
import time

import rclpy


def pump(node, seconds):
    threading.Thread(target=rclpy.spin, args=(node,), daemon=True).start()
    time.sleep(seconds)
