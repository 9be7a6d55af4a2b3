# Replaces NaN by the measurement before, which may be NaN as well.
# loses: survives_nan
# cause: survives-nan.second-in-a-row
# replaces: angles = np.where(np.isfinite(angles), angles, self.last_good)
# replaces: self.last_good = angles
before, self.last_good = self.last_good, angles
angles = np.where(np.isfinite(angles), angles, before)
