# One word for every charge.
# loses: status_kept
# cause: word-fits-charge.never-error
# replaces: message = String(data="operational" if self.battery_level > 0.0 else "error")
message = String(data="operational")
