# Publishes the mean of this place and the last one, as if the ball were noisy.
# loses: direction_right, bgr_right
# skips: light_changes, padding_right
# cause: direction.earlier-picture
# after: super().__init__("ball_tracker")
self.last: tuple[float, float] | None = None
# after: ball = find_ball(image)
if ball is not None and self.last is not None:
    ball = (ball[0] + self.last[0]) / 2, (ball[1] + self.last[1]) / 2
self.last = ball
