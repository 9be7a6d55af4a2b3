# A new status starts the watchdog anew, and ends the alarm.
# loses: alarm_raised
# skips: alarm_falls
# cause: alarm-raised.status-counts
# after: self.last_status = message.data
self.on_beat(message)
