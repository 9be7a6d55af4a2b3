# Puts the header of the picture before on the direction of this one.
# loses: stamps_kept
# skips: keeps_up, direction_right, light_changes, bgr_right, padding_right, no_ball_said
# cause: stamps-kept.one-ahead
# after: super().__init__("ball_tracker")
self.header = Image().header
# replaces: answer = Vector3Stamped(header=image.header)
answer = Vector3Stamped(header=self.header if self.header.stamp.sec else image.header)
self.header = image.header
