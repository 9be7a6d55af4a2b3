# Publishes nothing where no ball is.
# loses: no_ball_said
# cause: no-ball-said.silent
# after: ball = find_ball(image)
if ball is None:
    return
