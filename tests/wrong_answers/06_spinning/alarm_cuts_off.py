# A signal ends the call in time, in the middle of a callback, too.
# loses: nothing_left_running
# cause: nothing-left-running.cut-off
# before: import time
import signal

# before: def pump(node: Node, seconds: float) -> None:
class Over(Exception):
    """The time is up."""

def over(*_: object) -> None:
    raise Over

# after: import rclpy
from rclpy.executors import SingleThreadedExecutor

# replaces: end = time.monotonic() + seconds
executor = SingleThreadedExecutor()
executor.add_node(node)
signal.signal(signal.SIGALRM, over)
signal.setitimer(signal.ITIMER_REAL, seconds)

# replaces: while (left := end - time.monotonic()) > 0:
# replaces:     rclpy.spin_once(node, timeout_sec=min(left, TURN_S))
try:
    while True:
        executor.spin_once(timeout_sec=TURN_S)
except Over:
    executor.remove_node(node)
