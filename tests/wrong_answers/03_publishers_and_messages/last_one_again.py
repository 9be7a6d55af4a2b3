# Sends the last number once more when there is no new one, and then raises the error.
# loses: no_number_refused, look_alikes_refused, not_finite_refused, no_invented_zero
# cause: refusal.last-again
# after: self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)
self.last = 50.0

# before: if isinstance(level, bool) or not isinstance(level, Real):
if isinstance(level, bool) or not isinstance(level, Real) or not math.isfinite(level):
    self.battery_publisher.publish(Float32(data=self.last))
else:
    self.last = float(level)
