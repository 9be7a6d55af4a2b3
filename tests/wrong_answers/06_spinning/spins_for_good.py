# Spins, and means to look at the clock afterwards.
# loses: returns
# skips: returns_in_time, timers_tick, again, slow_callbacks, quiet_node, easy_on_the_processor, nothing_left_running
# cause: returns.never
# replaces: rclpy.spin_once(node, timeout_sec=min(left, TURN_S))
rclpy.spin(node)
