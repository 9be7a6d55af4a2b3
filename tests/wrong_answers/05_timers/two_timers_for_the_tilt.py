# A timer too many calls the same method.
# loses: tilt_count
# cause: rate.in-bursts
# after: self.create_timer(TILT_PERIOD_S, self.publish_tilt)
self.create_timer(TILT_PERIOD_S, self.publish_tilt)
