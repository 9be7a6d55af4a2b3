# Collects the good readings and sends them each second.
# loses: in_order
# cause: in-order.late
# after: super().__init__("battery_monitor")
self.waiting: list[Float32] = []
self.create_timer(1.0, self.send)

# before: def on_battery(self, message: Float32) -> None:
def send(self) -> None:
    for message in self.waiting:
        self.battery_publisher.publish(message)
    self.waiting.clear()

# replaces: self.battery_publisher.publish(message)
self.waiting.append(message)
