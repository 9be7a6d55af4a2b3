# What the filter hands back is thrown away, so each callback begins as the first one did.
# loses: noise_reduced, delay_bounded, survives_nan
# cause: noise-reduced.none
# replaces: filtered, self.memory = sosfilt(FILTER, angles[np.newaxis], axis=0, zi=self.memory)
filtered, _ = sosfilt(FILTER, angles[np.newaxis], axis=0, zi=self.memory)
