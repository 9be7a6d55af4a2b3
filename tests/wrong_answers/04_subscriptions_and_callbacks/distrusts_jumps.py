# Believes that a battery cannot jump. A fresh one has just been put in.
# loses: in_order, no_false_alarm
# cause: in-order.jumps-kept-back
# after: super().__init__("battery_monitor")
self.last: float | None = None

# replaces: if EMPTY <= message.data <= FULL:
jump = self.last is not None and abs(message.data - self.last) > 10.0
good = EMPTY <= message.data <= FULL
if good:
    self.last = message.data
if good and not jump:
