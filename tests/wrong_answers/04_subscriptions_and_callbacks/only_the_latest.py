# A timer passes on what came last, twice a second. What came in between is lost.
# loses: in_order
# cause: in-order.some-lost
# after: super().__init__("battery_monitor")
self.latest: float | None = None
self.create_timer(0.5, self.send)

# before: def on_battery(self, message: Float32) -> None:
def send(self) -> None:
    if self.latest is not None:
        self.battery_publisher.publish(Float32(data=self.latest))
        self.latest = None

# replaces: self.battery_publisher.publish(message)
self.latest = message.data
