# 0.5 Hz typed as a period: two messages a second.
# loses: joint_rate
# cause: rate.period-for-frequency
# says: 2 Hz
# replaces: JOINT_PERIOD_S = 2.0  # 0.5 Hz: one message every two seconds
JOINT_PERIOD_S = 0.5
