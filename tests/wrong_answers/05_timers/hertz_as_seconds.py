# The rates are typed as if create_timer took hertz.
# loses: battery_count, tilt_count
# cause: rate.period-for-frequency
# says: 2 Hz
# says: create_timer(2.0
# replaces: BATTERY_PERIOD_S = 2.0  # 0.5 Hz: one message every two seconds
# replaces: TILT_PERIOD_S = 0.2  # 5 Hz: five messages every second
BATTERY_PERIOD_S = 0.5
TILT_PERIOD_S = 5.0
