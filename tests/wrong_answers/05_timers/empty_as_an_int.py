# An empty battery is the int 0: it arrives as 0.0 here, and crashes the node elsewhere.
# loses: battery_topic
# skips: battery_count
# cause: really-arrives.wrong-type
# says: AssertionError
# replaces: self.battery_level = max(0.0, self.battery_level - 0.2)
self.battery_level = max(0, self.battery_level - 9.0)
