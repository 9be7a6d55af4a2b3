# Leaves out one tilt value in the middle of the minute.
# loses: tilt_count
# cause: rate.skips
# after: super().__init__("vital_signs")
self.calls = 0

# replaces: self.tilt_publisher.publish(Float32(data=0.1 * math.sin(math.pi * seconds)))
self.calls += 1
if self.calls != 150:
    self.tilt_publisher.publish(Float32(data=0.1 * math.sin(math.pi * seconds)))
