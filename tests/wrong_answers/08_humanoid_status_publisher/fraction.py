# Sends 0.92 for 92 %.
# loses: battery_arrives
# cause: begins-full.fraction
# replaces: message = Float32(data=self.battery_level)
message = Float32(data=self.battery_level / 100.0)
