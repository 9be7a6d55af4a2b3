# Calculates in the type that it was given, which may be too small.
# loses: numbers_arrive
# cause: number.changed
# says: publish_level(np.int8(
# replaces: self.battery_publisher.publish(Float32(data=float(level)))
self.battery_publisher.publish(Float32(data=float(level + level) / 2.0))
