# The wrong axis: filters from joint to joint, and not along time.
# loses: noise_reduced, begins_near, restart_noticed, survives_nan, delay_bounded
# cause: noise-reduced.beside-the-joint
# replaces: filtered, self.memory = sosfilt(FILTER, angles[np.newaxis], axis=0, zi=self.memory)
filtered = sosfilt(FILTER, angles)[np.newaxis]
