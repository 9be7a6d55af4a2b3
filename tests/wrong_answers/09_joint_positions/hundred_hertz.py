# The joints as fast as a motor controller would send them.
# loses: joint_rate
# cause: rate.too-fast
# replaces: JOINT_PERIOD_S = 2.0  # 0.5 Hz: one message every two seconds
JOINT_PERIOD_S = 0.01
