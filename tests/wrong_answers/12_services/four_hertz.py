# The heart beats a little too slowly.
# loses: heartbeat_steady
# cause: heartbeat-steady.other-period
# says: 0.25 s
# replaces: HEARTBEAT_PERIOD_S = 0.2  # 5 Hz
HEARTBEAT_PERIOD_S = 0.25
