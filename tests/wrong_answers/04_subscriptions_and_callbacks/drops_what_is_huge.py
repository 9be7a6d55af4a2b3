# Takes more than a million for noise, and says nothing about it.
# loses: one_alarm
# cause: one-alarm.kinds-missed
# replaces: else:  # this includes nan, which isn't between any two numbers
elif not 1e6 < abs(message.data) < float("inf"):
