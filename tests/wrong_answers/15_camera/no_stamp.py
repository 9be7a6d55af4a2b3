# Leaves the header empty.
# loses: stamps_kept
# skips: keeps_up, direction_right, light_changes, bgr_right, padding_right, no_ball_said
# cause: stamps-kept.no-stamp
# replaces: answer = Vector3Stamped(header=image.header)
answer = Vector3Stamped()
