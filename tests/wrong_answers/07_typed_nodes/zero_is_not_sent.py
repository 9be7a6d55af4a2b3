# Leaves 0.0 out, as if it were no value.
# loses: numbers_arrive
# cause: numbers-arrive.zero-dropped
# replaces: self.battery_publisher.publish(Float32(data=float(level)))
if level:
    self.battery_publisher.publish(Float32(data=float(level)))
