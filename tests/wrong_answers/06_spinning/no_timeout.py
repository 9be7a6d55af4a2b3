# Works as long as the node is busy.
# loses: quiet_node
# cause: in-time.not-back
# replaces: rclpy.spin_once(node, timeout_sec=min(left, TURN_S))
rclpy.spin_once(node)
