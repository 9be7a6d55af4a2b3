# Ends ROS after the first call, as every main() does.
# loses: again, slow_callbacks, quiet_node
# cause: call.raises-later
# after:     rclpy.spin_once(node, timeout_sec=min(left, TURN_S))
rclpy.shutdown()
