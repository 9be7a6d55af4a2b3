# A timer shuts everything down after 30 s of robot time.
# loses: alive_at_end
# skips: ends_cleanly
# cause: alive-at-end.ended
# after: self.battery_level = 100.0
self.create_timer(30.0, rclpy.shutdown)
