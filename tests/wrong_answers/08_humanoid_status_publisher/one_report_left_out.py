# Leaves out one battery report.
# loses: battery_rate
# cause: rate.skips
# after: self.battery_level = 100.0
self.reports = 0

# replaces: self.battery_publisher.publish(message)
self.reports += 1
if self.reports != 6:
    self.battery_publisher.publish(message)
