# A message with a NaN gets no answer.
# loses: every_one_answered
# cause: every-one-answered.nan-left-out
# replaces: angles = np.where(np.isfinite(angles), angles, self.last_good)
if not np.isfinite(angles).all():
    return
