# Counts from 0 to 12.
# loses: twelve_values
# cause: length.one-off
# says: 13 values
# replaces: for joint in range(JOINT_COUNT)
for joint in range(JOINT_COUNT + 1)
