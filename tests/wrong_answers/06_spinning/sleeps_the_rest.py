# Works for three quarters of the time, and sleeps for the rest.
# loses: timers_tick
# cause: timers-tick.silence, timers-tick.too-few
# replaces: end = time.monotonic() + seconds
end = time.monotonic() + 0.75 * seconds

# after:     rclpy.spin_once(node, timeout_sec=min(left, TURN_S))
time.sleep(0.25 * seconds)
