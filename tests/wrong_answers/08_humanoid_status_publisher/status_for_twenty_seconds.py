# The timer of the status is canceled after 20 s.
# loses: status_kept
# cause: silence.of-one
# says: while messages kept arriving on /robot/battery
# replaces: self.status_publisher.publish(message)
self.status_publisher.publish(message)
self.told = getattr(self, "told", 0) + 1
if self.told == 20:
    self.status_timer.cancel()
