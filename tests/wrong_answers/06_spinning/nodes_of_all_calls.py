# One executor for all calls keeps the nodes of the calls before.
# loses: nothing_left_running
# also: quiet_node
# cause: nothing-left-running.another-node
# after: import rclpy
from rclpy.executors import SingleThreadedExecutor

# before: def pump(node: Node, seconds: float) -> None:
executors: list[SingleThreadedExecutor] = []

# before: end = time.monotonic() + seconds
if not executors:
    executors.append(SingleThreadedExecutor())
executors[0].add_node(node)

# replaces: rclpy.spin_once(node, timeout_sec=min(left, TURN_S))
executors[0].spin_once(timeout_sec=min(left, TURN_S))
