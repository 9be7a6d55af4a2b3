# Smooths the place of the ball over several pictures.
# loses: direction_right, bgr_right
# skips: light_changes, padding_right
# cause: direction.behind
# after: super().__init__("ball_tracker")
self.smooth: tuple[float, float] | None = None
# replaces: if ball is not None:
if ball is not None:
    old = self.smooth or ball
    ball = self.smooth = (0.8 * old[0] + 0.2 * ball[0], 0.8 * old[1] + 0.2 * ball[1])
