# Ends by itself as soon as the battery is empty.
# loses: alive_at_end
# skips: ends_cleanly
# cause: alive-at-end.empty
# after: self.battery_level = max(0.0, self.battery_level - random.uniform(*DRAIN_PERCENT))
if self.battery_level == 0.0:
    raise KeyboardInterrupt
