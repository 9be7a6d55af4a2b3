# Takes the first reading for a warm-up.
# loses: in_order
# cause: in-order.first-one-lost
# after: super().__init__("battery_monitor")
self.warm = False

# replaces: self.battery_publisher.publish(message)
if self.warm:
    self.battery_publisher.publish(message)
self.warm = True
