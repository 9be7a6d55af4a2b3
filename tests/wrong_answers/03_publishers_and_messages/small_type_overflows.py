# Calculates in the type that it was given, which may be too small.
# loses: numbers_arrive
# cause: number.changed
# says: np.int8(100)
# replaces: self.battery_publisher.publish(Float32(data=float(level)))
self.battery_publisher.publish(Float32(data=float(level + level) / 2.0))
