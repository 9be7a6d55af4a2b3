# The limits have a tolerance of a thousandth.
# loses: bad_kept_back, one_alarm
# cause: bad-kept-back.tolerance
# replaces: if EMPTY <= message.data <= FULL:
if EMPTY - 0.001 <= message.data <= FULL + 0.001:
