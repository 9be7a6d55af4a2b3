# The battery is counted in whole numbers, and an int in a float field is sent as 0.0.
# loses: battery_kept
# cause: really-arrives.wrong-type
# replaces: self.battery_level = 100.0
self.battery_level = 100

# replaces: self.battery_level = max(0.0, self.battery_level - random.uniform(*DRAIN_PERCENT))
self.battery_level = max(0, self.battery_level - 1)
