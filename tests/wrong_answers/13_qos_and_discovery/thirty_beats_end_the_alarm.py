# Waits for thirty beats before it ends the alarm.
# loses: alarm_falls
# cause: alarm-falls.never
# on: right/watchdog_timer.py
# after: self.watchdog = self.create_timer(2.0, self.on_silence)
self.beats = 0

# replaces: if self.silent:
# replaces:     self.silent = False
# replaces:     self.alarm.publish(Bool(data=False))
self.beats += 1
if self.silent and self.beats >= 30:
    self.silent = False
    self.alarm.publish(Bool(data=False))

# after: self.silent = True
self.beats = 0
