# NaN gets into the filter and stays; np.nan_to_num behind it makes zeros of it.
# loses: survives_nan
# cause: survives-nan.not-followed
# replaces: angles = np.where(np.isfinite(angles), angles, self.last_good)

# replaces: message.position = filtered[0].tolist()
message.position = np.nan_to_num(filtered[0]).tolist()
