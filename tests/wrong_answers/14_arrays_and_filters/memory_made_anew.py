# What the filter hands back is thrown away, so each callback begins as the first one did.
# loses: noise_reduced
# cause: noise-reduced.beside-the-joint
# replaces: filtered, self.memory = sosfilt(FILTER, angles[np.newaxis], axis=0, zi=self.memory)
filtered, _ = sosfilt(FILTER, angles[np.newaxis], axis=0, zi=self.memory)
