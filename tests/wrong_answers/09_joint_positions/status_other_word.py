# The status is no longer one of the two agreed words.
# loses: status_kept
# cause: one-of.other-text
# says: ok
# replaces: message = String(data="operational" if self.battery_level > 0.0 else "error")
message = String(data="ok")
