# Grants the sensor a tenth of a percent beyond the limits.
# loses: bad_kept_back, one_alarm
# cause: bad-kept-back.tolerance
# replaces: if EMPTY <= message.data <= FULL:
if EMPTY - 0.1 <= message.data <= FULL + 0.1:
