# A low battery counts as empty.
# loses: status_kept
# cause: word-fits-charge.too-early
# replaces: message = String(data="operational" if self.battery_level > 0.0 else "error")
message = String(data="operational" if self.battery_level > 30.0 else "error")
