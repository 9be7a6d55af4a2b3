# The level begins as an int, so the first report arrives as 0.0.
# loses: battery_topic
# skips: battery_count
# cause: really-arrives.wrong-type
# says: in message 1
# replaces: self.battery_level = 100.0
self.battery_level = 100

# replaces: self.battery_level = max(0.0, self.battery_level - 0.2)
# replaces: self.battery_publisher.publish(Float32(data=self.battery_level))
self.battery_publisher.publish(Float32(data=self.battery_level))
self.battery_level -= 0.2
