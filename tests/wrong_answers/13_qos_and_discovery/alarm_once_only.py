# The alarm is raised in the first silence, and in no other.
# loses: alarm_raised
# skips: alarm_falls
# cause: alarm-raised.first-only
# after: self.alarm: bool | None = None
self.was_raised = False

# replaces: if alarm != self.alarm:
if alarm != self.alarm and not (alarm and self.was_raised):
    self.was_raised = alarm or self.was_raised
