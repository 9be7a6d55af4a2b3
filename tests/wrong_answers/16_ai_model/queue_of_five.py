# Five pictures wait, as with qos_profile_sensor_data.
# loses: fresh
# cause: fresh.old-pictures
# on: right/groups_and_threads.py
# replaces: NEWEST = QoSProfile(history=HistoryPolicy.KEEP_LAST, depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)
NEWEST = QoSProfile(history=HistoryPolicy.KEEP_LAST, depth=5, reliability=ReliabilityPolicy.BEST_EFFORT)
