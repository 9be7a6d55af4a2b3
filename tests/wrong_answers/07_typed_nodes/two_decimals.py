# Rounds to two decimals.
# loses: numbers_arrive
# cause: numbers-arrive.rounded
# says: 0.41
# replaces: self.battery_publisher.publish(Float32(data=float(level)))
self.battery_publisher.publish(Float32(data=round(float(level), 2)))
