# Keeps the level and repeats it by a timer, so that there is more on the wire than was said.
# loses: floats_arrive, zero_arrives, numbers_arrive
# cause: number.sent-again
# after: self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)
self.level = 100.0
self.create_timer(0.02, self.publish)

# before: def publish_level(self, level: object) -> None:
def publish(self) -> None:
    self.battery_publisher.publish(Float32(data=self.level))

# replaces: self.battery_publisher.publish(Float32(data=float(level)))
self.level = float(level)
self.publish()
