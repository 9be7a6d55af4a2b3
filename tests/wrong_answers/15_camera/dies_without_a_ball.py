# Unpacks None where no ball is.
# loses: keeps_up, refuses_others, bgr_right, padding_right, no_ball_said
# cause: error.exception
# replaces: if ball is not None:
# replaces:     answer.vector.x, answer.vector.y, answer.vector.z = direction(*ball)
answer.vector.x, answer.vector.y, answer.vector.z = direction(*ball)
