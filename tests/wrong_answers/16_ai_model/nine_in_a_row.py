# Takes nine tilted samples in a row for a fall.
# loses: fall_reported
# cause: fall-reported.on-a-jolt
# replaces: TILTED_SAMPLES = 10  # after this many in a row, the robot has fallen
TILTED_SAMPLES = 9
