# A timer shuts everything down after twenty seconds of robot time.
# loses: alive_at_end
# cause: alive-at-end.ended
# after: self.battery_level = 100.0
self.create_timer(20.0, rclpy.shutdown)
