# The battery is published once, when the node is made: a listener may hear that one, or come too late for it.
# loses: battery_count
# cause: no-message.silent-beside-others, silence.of-one
# replaces: self.create_timer(BATTERY_PERIOD_S, self.publish_battery)
self.publish_battery()
