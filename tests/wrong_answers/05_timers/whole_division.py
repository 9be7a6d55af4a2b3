# Five times a second, by whole division: the period is 0 s.
# loses: tilt_count
# cause: rate.without-a-pause
# replaces: TILT_PERIOD_S = 0.2  # 5 Hz: five messages every second
TILT_PERIOD_S = 1 // 5
