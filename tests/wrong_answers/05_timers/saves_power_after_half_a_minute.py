# After half of the minute the tilt comes half as often, to save power.
# loses: tilt_count
# cause: rate.changes
# says: one message every 0.2 s until
# replaces: self.create_timer(TILT_PERIOD_S, self.publish_tilt)
self.tilts = 0
self.create_timer(TILT_PERIOD_S, self.publish_tilt)

# replaces: seconds = self.get_clock().now().nanoseconds / 1e9
self.tilts += 1
if self.tilts > 150 and self.tilts % 2:
    return
seconds = self.get_clock().now().nanoseconds / 1e9
