# Knows the bad reading that the task prints, and no other.
# loses: bad_kept_back, one_alarm
# cause: bad-kept-back.many-passed-on
# replaces: if EMPTY <= message.data <= FULL:
if message.data != -3.0:
