# The charge is an int until it is drained for the first time.
# loses: battery_arrives
# cause: really-arrives.wrong-type
# says: message 1
# says: AssertionError: The 'data' field must be of type 'float'
# replaces: self.battery_level = 100.0
self.battery_level = 100

# replaces: self.battery_level = max(0.0, self.battery_level - random.uniform(*DRAIN_PERCENT))
# replaces: message = Float32(data=self.battery_level)
# replaces: self.battery_publisher.publish(message)
message = Float32(data=self.battery_level)
self.battery_publisher.publish(message)
self.battery_level = max(0.0, self.battery_level - random.uniform(*DRAIN_PERCENT))
