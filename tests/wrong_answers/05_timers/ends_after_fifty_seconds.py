# A timer shuts everything down after 50 s of robot time.
# loses: alive_at_end
# cause: alive-at-end.ended
# after: super().__init__("vital_signs")
self.create_timer(50.0, rclpy.shutdown)
