# Publishes the charge five times.
# loses: battery_rate
# cause: silence.of-one
# says: the last of 5 messages
# says: while messages kept arriving on /robot/status
# after: self.battery_level = 100.0
self.left = 5

# replaces: self.battery_publisher.publish(message)
if self.left > 0:
    self.battery_publisher.publish(message)
self.left -= 1
