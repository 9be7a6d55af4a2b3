# An int in a float field is sent as 0.0.
# loses: numbers_arrive
# cause: numbers-arrive.not-converted
# replaces: self.battery_publisher.publish(Float32(data=float(level)))
self.battery_publisher.publish(Float32(data=level))
