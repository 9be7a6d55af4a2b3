# Rounds to two decimals.
# loses: numbers_arrive
# cause: numbers-arrive.rounded
# replaces: self.battery_publisher.publish(Float32(data=float(level)))
self.battery_publisher.publish(Float32(data=round(float(level), 2)))
