# The battery is full again with the int 100, which arrives as 0.0 in every tenth report.
# loses: battery_topic
# skips: battery_count
# cause: really-arrives.wrong-type
# says: AssertionError
# replaces: self.battery_level = max(0.0, self.battery_level - 0.2)
self.battery_level -= 10.0
if self.battery_level <= 0.0:
    self.battery_level = 100
