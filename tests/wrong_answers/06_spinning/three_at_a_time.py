# Looks at the clock after every third callback only.
# loses: slow_callbacks
# cause: slow-callbacks.several
# replaces: while (left := end - time.monotonic()) > 0:
# replaces:     rclpy.spin_once(node, timeout_sec=min(left, TURN_S))
while time.monotonic() < end:
    for _ in range(3):
        rclpy.spin_once(node, timeout_sec=TURN_S / 3)
