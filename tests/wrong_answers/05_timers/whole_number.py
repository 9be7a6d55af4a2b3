# An int in a float field arrives as 0.0.
# loses: battery_topic
# skips: battery_count
# cause: really-arrives.wrong-type
# says: AssertionError
# replaces: self.battery_publisher.publish(Float32(data=self.battery_level))
self.battery_publisher.publish(Float32(data=round(self.battery_level)))
