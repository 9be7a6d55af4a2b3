# A String message carries a text, not a dict.
# loses: battery_arrives, battery_rate, status_kept, alive_at_end
# cause: error.wrong-value-type
# says: has the type string
# says: dict
# replaces: message = String(data="operational" if self.battery_level > 0.0 else "error")
message = String(data={"state": "operational" if self.battery_level > 0.0 else "error"})
