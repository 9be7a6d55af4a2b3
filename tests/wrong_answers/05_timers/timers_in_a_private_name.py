# Collects its timers in an attribute in which Node keeps them.
# loses: program_runs
# cause: error.private-name-taken
# says: _timers
# replaces: self.create_timer(BATTERY_PERIOD_S, self.publish_battery)
self._timers = {}
self._timers["battery"] = self.create_timer(BATTERY_PERIOD_S, self.publish_battery)
