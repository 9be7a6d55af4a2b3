# The limit is shorter than the time between two beats.
# loses: no_false_alarm
# skips: alarm_falls
# cause: no-false-alarm.while-beating
# replaces: LOOK_PERIOD_S = 0.2
# replaces: LONGEST_SILENCE_S = 2.0
LOOK_PERIOD_S = 0.02
LONGEST_SILENCE_S = 0.1
