# Collects good readings, and sends ten at a time.
# loses: in_order
# cause: in-order.in-groups
# after: self.create_subscription(Float32, "/robot/battery", self.on_battery, 10)
self.waiting = []

# replaces: self.battery_publisher.publish(message)
self.waiting.append(message)
if len(self.waiting) == 10:
    for one in self.waiting:
        self.battery_publisher.publish(one)
    self.waiting.clear()
