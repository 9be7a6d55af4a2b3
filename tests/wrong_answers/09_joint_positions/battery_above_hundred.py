# The battery starts at 4200 mAh, not at 100 percent.
# loses: battery_kept
# cause: within.not-limited
# says: 4200
# replaces: self.battery_level = 100.0
self.battery_level = 4200.0
