# The alarm says whether the robot has said "error".
# loses: alarm_raised, no_false_alarm
# skips: alarm_falls
# cause: alarm-raised.with-the-status
# replaces: alarm = time.monotonic() - self.last_beat > LONGEST_SILENCE_S
alarm = self.last_status == "error"
