# A battery that is not charged cannot rise: takes a higher reading for a bad one.
# loses: in_order, no_false_alarm
# cause: in-order.taken-for-bad
# after: super().__init__("battery_monitor")
self.last = FULL

# replaces: if EMPTY <= message.data <= FULL:
if EMPTY <= message.data <= self.last:
    self.last = message.data
