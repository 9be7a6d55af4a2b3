# Cancels all timers at the end, so that nothing goes on.
# loses: again, nothing_left_running
# cause: again.timers-canceled
# after:     rclpy.spin_once(node, timeout_sec=min(left, TURN_S))
for timer in node.timers:
    timer.cancel()
