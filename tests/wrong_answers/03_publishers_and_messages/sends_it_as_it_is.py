# Sends what it is given, and trusts the type hint.
# loses: numbers_arrive, no_number_refused, look_alikes_refused, not_finite_refused, no_invented_zero
# cause: number.not-converted
# says: an int, returned
# replaces: if isinstance(level, bool) or not isinstance(level, Real):
# replaces:     raise TypeError(f"a charge is a number, not {level!r}")
# replaces: if not math.isfinite(level):
# replaces:     raise ValueError(f"a charge is a finite number, not {level}")
# replaces: self.battery_publisher.publish(Float32(data=float(level)))
self.battery_publisher.publish(Float32(data=level))
