# Stores the number, and a timer sends it.
# loses: floats_arrive, zero_arrives, numbers_arrive
# cause: number.sent-later
# says: published: nothing
# after: self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)
self.waiting: list[float] = []
self.create_timer(0.03, self.send)

# before: def publish_level(self, level: object) -> None:
def send(self) -> None:
    while self.waiting:
        self.battery_publisher.publish(Float32(data=self.waiting.pop(0)))

# replaces: self.battery_publisher.publish(Float32(data=float(level)))
self.waiting.append(float(level))
