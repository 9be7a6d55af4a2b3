# Counts from 1 and ends one short.
# loses: twelve_values
# cause: length.one-off
# says: 11 values
# replaces: for joint in range(JOINT_COUNT)
for joint in range(1, JOINT_COUNT)
