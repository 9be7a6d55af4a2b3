# Calls rclpy.init, and ignores the error that somebody has called it already.
# loses: nothing_left_running
# cause: nothing-left-running.not-its-own
# before: end = time.monotonic() + seconds
try:
    rclpy.init()
except RuntimeError:
    pass
