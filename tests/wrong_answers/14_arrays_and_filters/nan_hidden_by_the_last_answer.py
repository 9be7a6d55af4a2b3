# NaN gets into the filter and stays; the last good answer is published in its place.
# loses: survives_nan
# cause: survives-nan.not-followed
# replaces: angles = np.where(np.isfinite(angles), angles, self.last_good)
# replaces: self.last_good = angles

# replaces: message.position = filtered[0].tolist()
self.last_good = np.where(np.isfinite(filtered[0]), filtered[0], self.last_good)
message.position = self.last_good.tolist()
