# Says error once, like an alarm, and then goes on as before.
# loses: status_kept
# cause: word-fits-charge.error-not-kept
# after: self.battery_level = 100.0
self.complained = False

# replaces: message = String(data="operational" if self.battery_level > 0.0 else "error")
message = String(data="operational")
if self.battery_level <= 0.0 and not self.complained:
    self.complained = True
    message.data = "error"
