# The timer of the battery is canceled after 20 s. The battery is not empty by then.
# loses: battery_rate
# cause: silence.of-one
# says: while messages kept arriving on /robot/status
# replaces: DRAIN_PERCENT = (7.0, 10.0)  # a worn battery: empty within half a minute
DRAIN_PERCENT = (2.0, 3.0)

# replaces: self.battery_publisher.publish(message)
self.battery_publisher.publish(message)
self.sent = getattr(self, "sent", 0) + 1
if self.sent == 10:
    self.battery_timer.cancel()
