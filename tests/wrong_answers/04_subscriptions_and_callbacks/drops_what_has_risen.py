# Passes on nothing that is more than 20 % above the lowest reading so far.
# loses: in_order
# cause: in-order.risen-kept-back
# after: super().__init__("battery_monitor")
self.lowest = FULL

# replaces: self.battery_publisher.publish(message)
if message.data <= self.lowest + 20.0:
    self.lowest = message.data
    self.battery_publisher.publish(message)
