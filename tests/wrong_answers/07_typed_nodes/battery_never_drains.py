# Reports the same charge for ever.
# loses: reports_as_before
# cause: drains.never
# replaces: self.level = max(0.0, self.level - DRAIN_PERCENT)
self.level = max(0.0, self.level)
