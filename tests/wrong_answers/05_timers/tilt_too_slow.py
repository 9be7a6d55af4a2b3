# 5 Hz typed as 0.5 s: a digit too far.
# loses: tilt_count
# cause: rate.evenly-too-slow, rate.too-slow
# says: 2 Hz
# says: create_timer(0.2
# replaces: TILT_PERIOD_S = 0.2  # 5 Hz: five messages every second
TILT_PERIOD_S = 0.5
