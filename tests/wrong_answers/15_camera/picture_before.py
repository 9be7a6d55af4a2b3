# Puts the header of this picture on the direction of the one before.
# loses: stamps_kept
# skips: keeps_up, direction_right, light_changes, bgr_right, padding_right, no_ball_said
# cause: stamps-kept.one-behind
# after: super().__init__("ball_tracker")
self.before: Image | None = None
# replaces: ball = find_ball(image)
ball = find_ball(self.before or image)
self.before = image
