# A letter is missing in the name of the field.
# loses: status_kept
# cause: one-of.empty
# says: AssertionError: Invalid arguments passed to constructor
# replaces: message = String(data="operational" if self.battery_level > 0.0 else "error")
message = String(dta="operational" if self.battery_level > 0.0 else "error")
