# Makes a node of its own for the time of the call.
# loses: nothing_left_running
# cause: nothing-left-running.not-its-own
# before: end = time.monotonic() + seconds
helper = Node("helper")

# after:     rclpy.spin_once(node, timeout_sec=min(left, TURN_S))
helper.destroy_node()
