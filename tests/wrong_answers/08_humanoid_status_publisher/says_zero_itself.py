# The field is never set.
# loses: battery_arrives
# cause: really-arrives.zero
# replaces: message = Float32(data=self.battery_level)
message = Float32()
