# Knows the upper limit wrongly.
# loses: bad_kept_back, one_alarm
# cause: bad-kept-back.other-limit
# replaces: if EMPTY <= message.data <= FULL:
if EMPTY <= message.data <= 200.0:
