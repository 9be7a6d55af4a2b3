# 0 < charge < 100: an empty and a full battery are taken for faults.
# loses: in_order, no_false_alarm
# cause: in-order.limits-kept-back
# replaces: if EMPTY <= message.data <= FULL:
if EMPTY < message.data < FULL:
