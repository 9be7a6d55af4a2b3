# NaN becomes 0, as np.nan_to_num does it.
# loses: survives_nan
# cause: survives-nan.other-angle
# replaces: angles = np.where(np.isfinite(angles), angles, self.last_good)
angles = np.nan_to_num(angles)
