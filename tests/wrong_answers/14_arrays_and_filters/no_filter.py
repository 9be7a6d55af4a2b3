# Replaces NaN, but filters nothing.
# loses: noise_reduced
# cause: noise-reduced.none
# replaces: filtered, self.memory = sosfilt(FILTER, angles[np.newaxis], axis=0, zi=self.memory)
filtered = angles[np.newaxis]
