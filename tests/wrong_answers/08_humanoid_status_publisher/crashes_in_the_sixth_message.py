# A list runs out after ten seconds of robot time.
# loses: alive_at_end
# skips: ends_cleanly
# cause: error.exception
# says: IndexError
# after: self.battery_level = 100.0
self.marks = [1, 2, 3, 4, 5]

# after: self.battery_level = max(0.0, self.battery_level - random.uniform(*DRAIN_PERCENT))
self.marks.pop()
