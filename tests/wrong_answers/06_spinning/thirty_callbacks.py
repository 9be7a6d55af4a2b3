# Stops working after thirty callbacks, and waits for the end.
# loses: timers_tick
# cause: timers-tick.too-few
# replaces: end = time.monotonic() + seconds
end = time.monotonic() + seconds
handled = 0

# replaces: rclpy.spin_once(node, timeout_sec=min(left, TURN_S))
handled += 1
if handled > 30:
    time.sleep(left)
else:
    rclpy.spin_once(node, timeout_sec=min(left, TURN_S))
