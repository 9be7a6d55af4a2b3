# Hands callbacks to threads, and does not wait for them.
# loses: nothing_left_running
# cause: nothing-left-running.still-works
# after: import rclpy
from rclpy.executors import MultiThreadedExecutor

# replaces: while (left := end - time.monotonic()) > 0:
# replaces:     rclpy.spin_once(node, timeout_sec=min(left, TURN_S))
executor = MultiThreadedExecutor()
executor.add_node(node)
while (left := end - time.monotonic()) > 0:
    executor.spin_once(timeout_sec=left)
executor.remove_node(node)
