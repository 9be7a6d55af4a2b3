# Counts whole tenths of a second.
# loses: returns_in_time
# also: again
# cause: in-time.short-calls
# replaces: while (left := end - time.monotonic()) > 0:
# replaces:     rclpy.spin_once(node, timeout_sec=min(left, TURN_S))
for step in range(1, round(seconds / 0.1 - 0.4) + 1):
    while (left := end - seconds + 0.1 * step - time.monotonic()) > 0:
        rclpy.spin_once(node, timeout_sec=left)
