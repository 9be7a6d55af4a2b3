# An exception in the callback ends the node at the first NaN.
# loses: every_one_answered, restart_noticed, survives_nan
# cause: error.exception
# before: angles = np.where(np.isfinite(angles), angles, self.last_good)
if not np.isfinite(angles).all():
    raise ValueError("an encoder is broken")
