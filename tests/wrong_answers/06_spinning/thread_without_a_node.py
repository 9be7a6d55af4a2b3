# The thread that spins is left behind, with an executor that has no node any more.
# loses: nothing_left_running
# cause: nothing-left-running.thread-left
# before: import time
import threading

# after: import rclpy
from rclpy.executors import SingleThreadedExecutor

# replaces: end = time.monotonic() + seconds
executor = SingleThreadedExecutor()
threading.Thread(target=executor.spin, daemon=True).start()

# replaces: while (left := end - time.monotonic()) > 0:
# replaces:     rclpy.spin_once(node, timeout_sec=min(left, TURN_S))
end = time.monotonic() + seconds
while (left := end - time.monotonic()) > 0:
    rclpy.spin_once(node, timeout_sec=min(left, TURN_S))
