# When nothing was ready for a while, it returns.
# loses: quiet_node
# cause: in-time.ended-by-silence
# replaces: while (left := end - time.monotonic()) > 0:
# replaces:     rclpy.spin_once(node, timeout_sec=min(left, TURN_S))
while (left := end - time.monotonic()) > 0:
    before = time.monotonic()
    rclpy.spin_once(node, timeout_sec=min(left, 0.3))
    if time.monotonic() - before >= 0.3:
        break
