# A period in milliseconds: the tilt would come every 200 s.
# loses: tilt_count
# cause: no-message.silent-beside-others
# replaces: TILT_PERIOD_S = 0.2  # 5 Hz: five messages every second
TILT_PERIOD_S = 200
