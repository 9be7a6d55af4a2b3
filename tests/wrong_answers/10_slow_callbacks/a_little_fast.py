# The heart beats every 0.093 s.
# loses: heartbeat_share
# cause: heartbeat-share.a-little-fast
# replaces: HEARTBEAT_PERIOD_S = 0.1  # 10 Hz
HEARTBEAT_PERIOD_S = 0.093
