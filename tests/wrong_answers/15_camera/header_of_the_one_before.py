# Keeps the header of each picture, and uses it one picture too late.
# loses: stamps_kept
# skips: keeps_up, direction_right, light_changes, bgr_right, padding_right, no_ball_said
# cause: stamps-kept.one-ahead
# after: super().__init__("ball_tracker")
self.header = Image().header
# replaces: answer = Vector3Stamped(header=image.header)
answer = Vector3Stamped(header=self.header)
self.header = image.header
