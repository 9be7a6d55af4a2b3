# While the status is "error", no alarm is raised.
# loses: alarm_raised
# skips: alarm_falls
# cause: alarm-raised.waits-for-a-status
# replaces: alarm = time.monotonic() - self.last_beat > LONGEST_SILENCE_S
alarm = time.monotonic() - self.last_beat > LONGEST_SILENCE_S and (self.alarm or self.last_status != "error")
