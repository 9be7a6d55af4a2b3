# Takes an infinite reading for a good one.
# loses: bad_kept_back, one_alarm
# cause: bad-kept-back.infinite-passed-on
# replaces: if EMPTY <= message.data <= FULL:
if EMPTY <= message.data <= FULL or message.data == float("inf"):
