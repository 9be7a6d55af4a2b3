# The alarm comes half a second too late.
# loses: alarm_raised
# skips: alarm_falls
# cause: alarm-raised.late
# replaces: LONGEST_SILENCE_S = 2.0
LONGEST_SILENCE_S = 3.35
