# Limits the value, and so turns nan into a full battery.
# loses: not_finite_refused, no_invented_zero
# cause: refusal.nan-limited
# replaces: if not math.isfinite(level):
# replaces:     raise ValueError(f"a charge is a finite number, not {level}")
# replaces: self.battery_publisher.publish(Float32(data=float(level)))
self.battery_publisher.publish(Float32(data=max(0.0, min(100.0, float(level)))))
