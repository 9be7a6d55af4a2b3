# A new status ends the alarm.
# on: right/watchdog_timer.py
# loses: alarm_falls
# cause: alarm-falls.with-the-status
# after: self.text = message.data
if self.silent:
    self.silent = False
    self.alarm.publish(Bool(data=False))
