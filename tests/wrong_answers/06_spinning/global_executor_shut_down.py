# Shuts down the executor that rclpy.spin_once uses for everybody.
# loses: again, slow_callbacks, quiet_node
# cause: call.raises-later
# after:     rclpy.spin_once(node, timeout_sec=min(left, TURN_S))
rclpy.get_global_executor().shutdown()
