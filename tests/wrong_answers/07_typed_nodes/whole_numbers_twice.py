# Sends a whole number twice.
# loses: numbers_arrive
# cause: numbers-arrive.sent-again
# after: self.battery_publisher.publish(Float32(data=float(level)))
if isinstance(level, int):
    self.battery_publisher.publish(Float32(data=float(level)))
