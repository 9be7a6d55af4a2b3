# When nothing was ready for a while, it sleeps until the end.
# loses: quiet_node
# cause: quiet-node.words-wait
# replaces: while (left := end - time.monotonic()) > 0:
# replaces:     rclpy.spin_once(node, timeout_sec=min(left, TURN_S))
while (left := end - time.monotonic()) > 0:
    before = time.monotonic()
    rclpy.spin_once(node, timeout_sec=min(left, 0.3))
    if time.monotonic() - before >= 0.3:
        time.sleep(max(0.0, end - time.monotonic()))
