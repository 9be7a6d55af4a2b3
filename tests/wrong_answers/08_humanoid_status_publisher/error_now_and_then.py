# The word follows a counter.
# loses: status_kept
# cause: word-fits-charge.changes
# after: self.battery_level = 100.0
self.count = 0

# replaces: message = String(data="operational" if self.battery_level > 0.0 else "error")
self.count += 1
message = String(data="error" if self.count % 5 == 0 else "operational")
