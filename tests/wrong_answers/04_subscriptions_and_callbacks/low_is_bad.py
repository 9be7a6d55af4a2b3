# Takes a low battery for a bad reading.
# loses: in_order, no_false_alarm
# cause: in-order.low-kept-back
# replaces: if EMPTY <= message.data <= FULL:
if 20.0 <= message.data <= FULL:
