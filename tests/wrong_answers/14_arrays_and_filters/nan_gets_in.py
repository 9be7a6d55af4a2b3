# NaN goes into the filter, and stays.
# loses: survives_nan
# cause: survives-nan.never-leaves
# replaces: angles = np.where(np.isfinite(angles), angles, self.last_good)

