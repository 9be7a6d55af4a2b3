# Ten looks a second at what has come, so as not to burn the processor.
# loses: words_handled, timers_tick
# skips: again
# cause: words-handled.one-a-round
# replaces: rclpy.spin_once(node, timeout_sec=min(left, TURN_S))
rclpy.spin_once(node, timeout_sec=0)
time.sleep(0.08)
