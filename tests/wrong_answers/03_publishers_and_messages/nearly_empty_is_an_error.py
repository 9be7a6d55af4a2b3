# Refuses a charge below one percent, but not zero.
# loses: floats_arrive
# cause: number.small-refused
# before: self.battery_publisher.publish(Float32(data=float(level)))
if 0.0 < level < 1.0:
    raise ValueError("this is a fraction, not a charge in percent")
