# The level goes up and down instead of draining.
# loses: battery_kept
# cause: never-rises.rises
# replaces: self.battery_level = max(0.0, self.battery_level - random.uniform(*DRAIN_PERCENT))
self.battery_level = 60.0 if self.battery_level > 70.0 else 80.0
