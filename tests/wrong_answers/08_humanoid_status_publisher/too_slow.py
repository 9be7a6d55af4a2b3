# Every three seconds.
# loses: battery_rate
# cause: rate.evenly-too-slow, rate.too-slow
# says: 0.33 Hz
# replaces: BATTERY_PERIOD_S = 2.0  # 0.5 Hz: one message every two seconds
BATTERY_PERIOD_S = 3.0
