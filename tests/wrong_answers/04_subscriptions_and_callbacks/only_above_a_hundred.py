# Does not look for readings below 0.
# loses: bad_kept_back, one_alarm
# cause: bad-kept-back.one-limit-missing
# replaces: if EMPTY <= message.data <= FULL:
if message.data <= FULL:
