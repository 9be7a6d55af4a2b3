# A comma at the end of the line makes a tuple of the state.
# loses: battery_arrives, battery_rate, status_kept, alive_at_end
# cause: error.wrong-value-type
# says: A comma at the end of a line turns the value into a one-item tuple
# replaces: message = String(data="operational" if self.battery_level > 0.0 else "error")
message = String()
message.data = "operational" if self.battery_level > 0.0 else "error",
