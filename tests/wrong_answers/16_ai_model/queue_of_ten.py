# Ten pictures wait in the queue of the subscription.
# loses: fresh
# cause: fresh.old-pictures
# on: right/groups_and_threads.py
# replaces: NEWEST = QoSProfile(history=HistoryPolicy.KEEP_LAST, depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)
NEWEST = QoSProfile(history=HistoryPolicy.KEEP_LAST, depth=10, reliability=ReliabilityPolicy.RELIABLE)
