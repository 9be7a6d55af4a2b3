# Does not send a number that equals the one before.
# loses: numbers_arrive
# cause: numbers-arrive.repeat-dropped
# says: .5)
# after: self.level = 100.0
self.last_sent: float | None = None

# before: self.battery_publisher.publish(Float32(data=float(level)))
if level == self.last_sent:
    return
self.last_sent = level
