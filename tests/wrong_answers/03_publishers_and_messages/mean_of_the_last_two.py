# Sends the mean of this number and the one before.
# loses: floats_arrive, zero_arrives, numbers_arrive
# cause: number.depends-on-earlier
# after: self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)
self.latest = None

# replaces: self.battery_publisher.publish(Float32(data=float(level)))
before = float(level) if self.latest is None else self.latest
self.latest = float(level)
self.battery_publisher.publish(Float32(data=(before + self.latest) / 2.0))
