# Accepts a ball only near the place where it has found the last one.
# loses: light_changes, bgr_right
# cause: direction.no-ball
# after: super().__init__("ball_tracker")
self.last = None
# after: ball = find_ball(image)
if ball is not None and self.last is not None and math.dist(ball, self.last) > 25.0:
    ball = None
self.last = ball or self.last
