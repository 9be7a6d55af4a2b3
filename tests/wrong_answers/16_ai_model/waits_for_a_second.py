# Waits for fifty tilted samples.
# loses: fall_reported
# cause: fall-reported.late
# replaces: TILTED_SAMPLES = 10  # after this many in a row, the robot has fallen
TILTED_SAMPLES = 50
