# The wrong axis: filters from joint to joint, and not along time.
# loses: filters
# skips: noise_reduced, delay_bounded, begins_near, restart_noticed, survives_nan
# cause: filters.mixes-joints
# replaces: filtered, self.memory = sosfilt(FILTER, angles[np.newaxis], axis=0, zi=self.memory)
filtered = sosfilt(FILTER, angles)[np.newaxis]
