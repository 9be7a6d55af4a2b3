# Takes a spin_once that lasts long for one in which nothing was ready, and returns.
# loses: slow_callbacks, quiet_node
# cause: in-time.ended-by-job
# replaces: while (left := end - time.monotonic()) > 0:
# replaces:     rclpy.spin_once(node, timeout_sec=min(left, TURN_S))
while (left := end - time.monotonic()) > 0:
    begin = time.monotonic()
    rclpy.spin_once(node, timeout_sec=min(left, 0.35))
    if 0.35 <= time.monotonic() - begin < left:
        return
