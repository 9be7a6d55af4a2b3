# The alarm comes after 20 s of silence.
# loses: alarm_raised
# skips: alarm_falls
# cause: alarm-raised.never
# replaces: LONGEST_SILENCE_S = 2.0
LONGEST_SILENCE_S = 20.0
