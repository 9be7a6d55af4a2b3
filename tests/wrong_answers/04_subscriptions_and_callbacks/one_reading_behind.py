# Holds each good reading until the next one comes.
# loses: in_order
# cause: in-order.held-back
# after: super().__init__("battery_monitor")
self.held: Float32 | None = None

# replaces: self.battery_publisher.publish(message)
if self.held is not None:
    self.battery_publisher.publish(self.held)
self.held = message
