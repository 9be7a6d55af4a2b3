# Ends after fifty readings.
# loses: in_order, one_alarm
# cause: in-order.ended
# after: super().__init__("battery_monitor")
self.heard = 0

# before: if EMPTY <= message.data <= FULL:
self.heard += 1
if self.heard > 50:
    raise KeyboardInterrupt
