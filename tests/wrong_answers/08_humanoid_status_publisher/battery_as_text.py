# The charge as a text.
# loses: battery_topic
# skips: battery_arrives, battery_rate
# cause: publishes.other-type
# says: String
# replaces: self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)
self.battery_publisher = self.create_publisher(String, "/robot/battery", 10)

# replaces: message = Float32(data=self.battery_level)
message = String(data=f"{self.battery_level:.0f}")
