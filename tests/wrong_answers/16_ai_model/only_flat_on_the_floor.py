# Asks for a tilt of 70°.
# loses: fall_reported
# cause: fall-reported.never
# replaces: TILT_DEG = 60.0  # a sample with more tilt than this counts as tilted
TILT_DEG = 70.0
