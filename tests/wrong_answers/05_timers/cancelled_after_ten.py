# The timer of the tilt cancels itself after ten ticks.
# loses: tilt_count
# cause: silence.of-one
# says: 10
# replaces: self.create_timer(TILT_PERIOD_S, self.publish_tilt)
self.ticks = 0
self.tilt_timer = self.create_timer(TILT_PERIOD_S, self.publish_tilt)

# after: self.tilt_publisher.publish(Float32(data=0.1 * math.sin(math.pi * seconds)))
self.ticks += 1
if self.ticks == 10:
    self.tilt_timer.cancel()
