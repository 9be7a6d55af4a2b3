# Collects readings in a list, and sends the newest first.
# loses: in_order
# cause: in-order.other-order
# after: super().__init__("battery_monitor")
self.waiting: list[float] = []
self.create_timer(0.5, self.send)

# before: def on_battery(self, message: Float32) -> None:
def send(self) -> None:
    while self.waiting:
        self.battery_publisher.publish(Float32(data=self.waiting.pop()))

# replaces: self.battery_publisher.publish(message)
self.waiting.append(message.data)
