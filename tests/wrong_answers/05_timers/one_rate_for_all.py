# One timer at 1 Hz does everything.
# loses: battery_count, tilt_count
# cause: rate.too-fast
# says: 1 Hz
# says: about 2 times the expected rate
# replaces: self.create_timer(HEARTBEAT_PERIOD_S, self.publish_heartbeat)
self.create_timer(1.0, self.publish_all)

# replaces: self.create_timer(BATTERY_PERIOD_S, self.publish_battery)
# replaces: self.create_timer(TILT_PERIOD_S, self.publish_tilt)

# before: def publish_heartbeat(self) -> None:
def publish_all(self) -> None:
    self.publish_heartbeat()
    self.publish_battery()
    self.publish_tilt()
