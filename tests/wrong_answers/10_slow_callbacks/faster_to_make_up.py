# Twice as many beats while there is time, to make up for those that are lost.
# loses: heartbeat_share, heartbeat_gap
# cause: heartbeat-share.nobody-serves-the-timer
# on: starter
# replaces: HEARTBEAT_PERIOD_S = 0.1  # 10 Hz
HEARTBEAT_PERIOD_S = 0.05
