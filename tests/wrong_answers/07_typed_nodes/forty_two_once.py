# A number that it has sent before is not sent again, if it is a whole one.
# loses: numbers_arrive
# cause: numbers-arrive.not-each-time
# says: once after 2 calls
# after: self.level = 100.0
self.sent: set[float] = set()

# replaces: self.battery_publisher.publish(Float32(data=float(level)))
if isinstance(level, int) and level in self.sent:
    return
self.sent.add(level)
self.battery_publisher.publish(Float32(data=float(level)))
