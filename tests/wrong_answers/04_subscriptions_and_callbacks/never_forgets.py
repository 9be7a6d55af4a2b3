# Once it has met a fault, it trusts the sensor no more.
# loses: in_order, no_false_alarm
# cause: in-order.stops-at-the-bad-one
# after: super().__init__("battery_monitor")
self.broken = False

# replaces: if EMPTY <= message.data <= FULL:
if not EMPTY <= message.data <= FULL:
    self.broken = True
if not self.broken:
