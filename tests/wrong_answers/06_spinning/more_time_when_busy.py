# After twenty iterations, it gives itself 0.4 s more.
# loses: quiet_node
# also: again
# cause: in-time.wait-begins-anew
# before: end = time.monotonic() + seconds
turns = 0
# replaces: rclpy.spin_once(node, timeout_sec=min(left, TURN_S))
turns += 1
if turns == 20:
    end += 0.4
rclpy.spin_once(node, timeout_sec=min(left, TURN_S))
