# Looks at the value when it has gone out.
# loses: no_number_refused, look_alikes_refused, not_finite_refused, no_invented_zero
# cause: refusal.too-late
# says: TypeError: a charge is a number, not
# before: if isinstance(level, bool) or not isinstance(level, Real):
charge = float(level) if isinstance(level, Real) else level
self.battery_publisher.publish(Float32(data=charge))

# replaces: self.battery_publisher.publish(Float32(data=float(level)))
