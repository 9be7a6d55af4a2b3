# Ends the alarm only when the status is operational.
# loses: alarm_falls
# cause: alarm-falls.waits-for-a-status
# after: alarm = time.monotonic() - self.last_beat > LONGEST_SILENCE_S
if self.alarm and self.last_status != "operational":
    return
