# Rests for half a second after a callback that took long, as if to give the robot a break.
# loses: slow_callbacks
# cause: slow-callbacks.late-after-job
# says: one job takes 0.4 s
# replaces: rclpy.spin_once(node, timeout_sec=min(left, TURN_S))
begun = time.monotonic()
rclpy.spin_once(node, timeout_sec=min(left, TURN_S))
if time.monotonic() - begun > 0.3:
    time.sleep(0.5)
