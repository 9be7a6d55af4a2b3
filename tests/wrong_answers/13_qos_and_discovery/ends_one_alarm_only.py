# The first alarm ends when the heart beats again, and a later one does not.
# loses: alarm_falls
# cause: alarm-falls.first-only
# after: self.alarm: bool | None = None
self.ended = 0

# replaces: if alarm != self.alarm:
if alarm != self.alarm and not (self.alarm and self.ended):
    self.ended += bool(self.alarm)
