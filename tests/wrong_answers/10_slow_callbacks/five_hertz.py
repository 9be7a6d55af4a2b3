# The heart beats five times a second.
# loses: heartbeat_share
# cause: heartbeat-share.other-period
# says: one every 0.2 s
# replaces: HEARTBEAT_PERIOD_S = 0.1  # 10 Hz
HEARTBEAT_PERIOD_S = 0.2
