# The drain has no floor.
# loses: battery_kept
# cause: within.not-limited
# replaces: self.battery_level = 100.0
self.battery_level = 0.5

# replaces: self.battery_level = max(0.0, self.battery_level - random.uniform(*DRAIN_PERCENT))
self.battery_level -= random.uniform(0.3, 0.5)
