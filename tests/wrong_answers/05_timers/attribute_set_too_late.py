# The first report is sent before the line that sets its charge.
# loses: program_runs
# cause: error.attribute-set-later
# replaces: self.battery_level = 100.0

# replaces: self.create_timer(BATTERY_PERIOD_S, self.publish_battery)
self.create_timer(BATTERY_PERIOD_S, self.publish_battery)
self.publish_battery()
self.battery_level = 100.0
