# Sends a share of 1 instead of percent.
# loses: floats_arrive, numbers_arrive
# cause: number.fraction
# replaces: self.battery_publisher.publish(Float32(data=float(level)))
self.battery_publisher.publish(Float32(data=float(level) / 100.0))
