# The level is wrapped in a list, as for an array.
# loses: battery_arrives
# cause: really-arrives.wrong-type
# says: list
# replaces: message = Float32(data=self.battery_level)
message = Float32(data=[self.battery_level])
