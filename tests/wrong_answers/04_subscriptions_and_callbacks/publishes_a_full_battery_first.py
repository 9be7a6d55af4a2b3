# Publishes a full battery before the first reading, so that nobody has to wait.
# loses: in_order
# cause: in-order.made-up-first
# after: super().__init__("battery_monitor")
self.begun = False

# before: if EMPTY <= message.data <= FULL:
if not self.begun:
    self.begun = True
    self.battery_publisher.publish(Float32(data=FULL))
