# Reads a field that the message does not have.
# loses: runs_on
# skips: line_rate, status_at_once, status_follows, alarm_raised, no_false_alarm, alarm_falls
# cause: error.unknown-field
# says: 'String' object has no attribute 'stamp'
# replaces: self.last_beat = time.monotonic()
self.last_beat = message.stamp
