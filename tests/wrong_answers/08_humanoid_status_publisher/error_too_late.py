# The word follows a level that is five seconds old.
# loses: status_kept
# cause: word-fits-charge.too-late
# after: self.battery_level = 100.0
self.history = [100.0] * 5

# replaces: message = String(data="operational" if self.battery_level > 0.0 else "error")
self.history.append(self.battery_level)
message = String(data="operational" if self.history.pop(0) > 0.0 else "error")
