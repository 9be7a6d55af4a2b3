# After the first alarm, half a second of silence is enough.
# loses: no_false_alarm
# skips: alarm_falls
# cause: no-false-alarm.later-one-early
# after: self.alarm: bool | None = None
self.limit = LONGEST_SILENCE_S

# replaces: alarm = time.monotonic() - self.last_beat > LONGEST_SILENCE_S
alarm = time.monotonic() - self.last_beat > self.limit
if alarm:
    self.limit = 0.55
