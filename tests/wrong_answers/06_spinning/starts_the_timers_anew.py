# Starts all timers anew at the end.
# loses: nothing_left_running
# cause: nothing-left-running.changed
# after:     rclpy.spin_once(node, timeout_sec=min(left, TURN_S))
for timer in node.timers:
    timer.reset()
