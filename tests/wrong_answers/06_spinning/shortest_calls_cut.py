# Short calls come back after one callback, whatever time is left.
# loses: returns_in_time
# also: again, slow_callbacks
# cause: in-time.short-calls
# before: end = time.monotonic() + seconds
if seconds < 0.1:
    rclpy.spin_once(node, timeout_sec=0.001)
    return
