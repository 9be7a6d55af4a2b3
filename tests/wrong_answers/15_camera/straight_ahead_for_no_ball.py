# Says that the ball is straight ahead where none is.
# loses: no_ball_said
# cause: no-ball-said.constant
# replaces: return None
return CENTER
