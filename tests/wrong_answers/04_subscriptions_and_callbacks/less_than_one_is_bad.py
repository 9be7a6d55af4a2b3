# Takes a charge between 0 and 1 % for a bad reading.
# loses: in_order, no_false_alarm
# cause: in-order.low-kept-back
# replaces: if EMPTY <= message.data <= FULL:
if message.data == EMPTY or 1.0 <= message.data <= FULL:
