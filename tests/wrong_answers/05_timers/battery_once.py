# The battery is published once, when the node is made.
# loses: battery_count
# cause: no-message.silent
# replaces: self.create_timer(BATTERY_PERIOD_S, self.publish_battery)
self.publish_battery()
