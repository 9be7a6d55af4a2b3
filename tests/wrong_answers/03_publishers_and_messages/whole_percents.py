# Rounds, because decimals are ugly.
# loses: floats_arrive, numbers_arrive
# cause: number.rounded
# replaces: self.battery_publisher.publish(Float32(data=float(level)))
self.battery_publisher.publish(Float32(data=float(round(level))))
