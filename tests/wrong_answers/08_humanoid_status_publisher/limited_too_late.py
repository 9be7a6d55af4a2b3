# The charge is cut to 0 only in the next callback, so one message is below 0.
# loses: battery_arrives
# cause: within.limited-too-late
# replaces: self.battery_level = max(0.0, self.battery_level - random.uniform(*DRAIN_PERCENT))
drain = random.uniform(*DRAIN_PERCENT) if self.battery_level > 0.0 else 0.0
self.battery_level = max(0.0, self.battery_level) - drain
