# Another word than the one that was agreed on.
# loses: status_kept
# cause: one-of.other-text
# says: "OPERATIONAL" on /robot/status
# replaces: message = String(data="operational" if self.battery_level > 0.0 else "error")
message = String(data="OPERATIONAL" if self.battery_level > 0.0 else "error")
