# A comma at the end of the line makes a tuple with one item.
# loses: battery_arrives
# cause: really-arrives.wrong-type
# says: A comma at the end of a line
# replaces: message = Float32(data=self.battery_level)
message = Float32()
message.data = self.battery_level,
