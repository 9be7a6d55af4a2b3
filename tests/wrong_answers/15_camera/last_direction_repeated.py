# Publishes the last direction again where no ball is.
# loses: no_ball_said
# cause: no-ball-said.repeated
# after: super().__init__("ball_tracker")
self.last = [0.0, 0.0, 1.0]
# replaces: if ball is not None:
# replaces:     answer.vector.x, answer.vector.y, answer.vector.z = direction(*ball)
if ball is not None:
    self.last = direction(*ball)
answer.vector.x, answer.vector.y, answer.vector.z = self.last
