# In the place of a NaN comes the mean of the other joints.
# loses: survives_nan
# cause: survives-nan.other-angle
# replaces: angles = np.where(np.isfinite(angles), angles, self.last_good)
angles = np.where(np.isfinite(angles), angles, np.nanmean(np.append(angles, 0.0)))
