# Each wait may be as long as the whole call.
# loses: quiet_node
# cause: in-time.wait-begins-anew
# replaces: rclpy.spin_once(node, timeout_sec=min(left, TURN_S))
rclpy.spin_once(node, timeout_sec=seconds)
