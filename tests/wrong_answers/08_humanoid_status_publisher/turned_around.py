# The condition is the wrong way round.
# loses: status_kept
# cause: word-fits-charge.turned-around
# replaces: message = String(data="operational" if self.battery_level > 0.0 else "error")
message = String(data="error" if self.battery_level > 0.0 else "operational")
