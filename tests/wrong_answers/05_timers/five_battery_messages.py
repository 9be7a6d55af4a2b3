# The battery reports five times.
# loses: battery_count
# cause: silence.of-one
# says: the last of 5 messages
# after: super().__init__("vital_signs")
self.reports_left = 5

# replaces: self.battery_publisher.publish(Float32(data=self.battery_level))
if self.reports_left > 0:
    self.battery_publisher.publish(Float32(data=self.battery_level))
self.reports_left -= 1
