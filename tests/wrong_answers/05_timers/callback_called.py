# The method is called on the spot, and the timer gets None.
# loses: program_runs
# cause: error.callback-called
# replaces: self.create_timer(TILT_PERIOD_S, self.publish_tilt)
self.create_timer(TILT_PERIOD_S, self.publish_tilt())
