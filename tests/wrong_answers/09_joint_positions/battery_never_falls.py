# The line that drains the battery is gone.
# loses: battery_kept
# cause: drains.never
# replaces: self.battery_level = max(0.0, self.battery_level - random.uniform(*DRAIN_PERCENT))
