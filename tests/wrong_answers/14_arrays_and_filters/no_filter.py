# Replaces NaN, but filters nothing.
# loses: filters
# skips: noise_reduced, delay_bounded, begins_near, restart_noticed, survives_nan
# cause: filters.passes-through
# replaces: filtered, self.memory = sosfilt(FILTER, angles[np.newaxis], axis=0, zi=self.memory)
filtered = angles[np.newaxis]
