# The charge has no lower limit.
# loses: battery_arrives
# cause: within.not-limited
# says: values from 0 to 100 %
# replaces: self.battery_level = max(0.0, self.battery_level - random.uniform(*DRAIN_PERCENT))
self.battery_level = self.battery_level - random.uniform(*DRAIN_PERCENT)
