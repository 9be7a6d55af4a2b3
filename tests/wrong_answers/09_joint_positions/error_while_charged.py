# The condition of the status was touched on the way.
# loses: status_kept
# cause: word-fits-charge.turned-around
# replaces: message = String(data="operational" if self.battery_level > 0.0 else "error")
message = String(data="operational" if self.battery_level < 0.0 else "error")
