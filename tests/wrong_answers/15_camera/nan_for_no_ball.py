# Says NaN where no ball is.
# loses: no_ball_said
# cause: no-ball-said.no-number
# replaces: return None
return math.nan, math.nan
