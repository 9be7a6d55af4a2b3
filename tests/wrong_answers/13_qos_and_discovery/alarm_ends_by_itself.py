# The alarm lasts for half a second.
# loses: alarm_falls
# cause: alarm-falls.in-silence
# replaces: alarm = time.monotonic() - self.last_beat > LONGEST_SILENCE_S
alarm = LONGEST_SILENCE_S < time.monotonic() - self.last_beat < LONGEST_SILENCE_S + 0.5
