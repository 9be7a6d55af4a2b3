# Publishes a constant.
# loses: battery_arrives
# cause: drains.never
# says: 100 %
# replaces: message = Float32(data=self.battery_level)
message = Float32(data=100.0)
