# The tilt is still to be done; the battery is no misspelled tilt.
# loses: tilt_topic
# skips: tilt_count
# cause: publishes.nothing
# replaces: self.tilt_publisher = self.create_publisher(Float32, "/robot/tilt", 10)

# replaces: self.create_timer(TILT_PERIOD_S, self.publish_tilt)
