# Fills the place of NaN from the joints beside it in the array.
# loses: survives_nan
# cause: survives-nan.other-angle
# replaces: angles = np.where(np.isfinite(angles), angles, self.last_good)
good = np.isfinite(angles)
if good.any():
    angles = np.interp(np.arange(angles.size), np.flatnonzero(good), angles[good])
else:
    angles = self.last_good
