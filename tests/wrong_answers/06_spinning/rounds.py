# Twice a second it handles all that is there, and sleeps in between.
# loses: timers_tick
# cause: timers-tick.too-few
# replaces: rclpy.spin_once(node, timeout_sec=min(left, TURN_S))
for _ in range(30):
    if time.monotonic() < end:
        rclpy.spin_once(node, timeout_sec=0)
time.sleep(max(0.0, min(0.5, end - time.monotonic())))
