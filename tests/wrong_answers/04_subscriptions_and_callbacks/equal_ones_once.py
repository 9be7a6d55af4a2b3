# Passes a reading on only if it differs from the one before.
# loses: in_order
# cause: in-order.equal-kept-back
# after: super().__init__("battery_monitor")
self.last = -1.0

# replaces: self.battery_publisher.publish(message)
if message.data != self.last:
    self.battery_publisher.publish(message)
self.last = message.data
