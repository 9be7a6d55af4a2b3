# Copies the seconds of the stamp, and not its nanoseconds.
# loses: stamps_kept
# skips: keeps_up, direction_right, light_changes, bgr_right, padding_right, no_ball_said
# cause: stamps-kept.whole-seconds
# replaces: answer = Vector3Stamped(header=image.header)
answer = Vector3Stamped()
answer.header.stamp.sec = image.header.stamp.sec
