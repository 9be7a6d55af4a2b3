# Takes 45° for the limit, not 60°.
# loses: fall_reported
# cause: fall-reported.on-leaning
# replaces: TILT_DEG = 60.0  # a sample with more tilt than this counts as tilted
TILT_DEG = 45.0
