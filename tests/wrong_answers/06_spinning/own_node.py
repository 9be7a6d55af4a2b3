# Spins a node, but not the one that was given.
# loses: words_handled, timers_tick, slow_callbacks, quiet_node, nothing_left_running
# skips: again
# cause: words-handled.none
# says: 0 of 20
# before: end = time.monotonic() + seconds
node = Node("pump")

# after:     rclpy.spin_once(node, timeout_sec=min(left, TURN_S))
node.destroy_node()
