# The night lasts three seconds.
# loses: runs_until_told
# skips: walks_its_rounds, guard_on_the_graph, arms_parked, ends_cleanly, node_gone
# cause: alive-at-end.ended
# before: import rclpy
import time

# replaces: rclpy.spin(guard)
morning = time.monotonic() + 3.0
while time.monotonic() < morning:
    rclpy.spin_once(guard, timeout_sec=0.1)
