# The charge stands still from 60 % on.
# loses: battery_arrives
# cause: drains.stops
# replaces: self.battery_level = max(0.0, self.battery_level - random.uniform(*DRAIN_PERCENT))
self.battery_level = max(60.0, self.battery_level - random.uniform(*DRAIN_PERCENT))
