# The first report comes after twelve seconds.
# loses: battery_count
# cause: rate.begins-late, no-message.silent-beside-others
# after: super().__init__("vital_signs")
self.calls = 0

# replaces: self.battery_publisher.publish(Float32(data=self.battery_level))
self.calls += 1
if self.calls > 5:
    self.battery_publisher.publish(Float32(data=self.battery_level))
