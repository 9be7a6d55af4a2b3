# The timer of the status is canceled after twenty seconds of robot time.
# loses: status_kept
# cause: silence.of-one
# says: the last of 20 messages
# after: self.battery_level = 100.0
self.told = 0

# after: self.status_publisher.publish(message)
self.told += 1
if self.told == 20:
    self.status_timer.cancel()
