# A heartbeat every 1.15 s: near enough for a glance, not for a count.
# loses: heartbeat_count
# cause: rate.evenly-too-slow, rate.too-slow
# says: create_timer(1.0
# replaces: HEARTBEAT_PERIOD_S = 1.0  # 1 Hz
HEARTBEAT_PERIOD_S = 1.15
