# filtfilt over the last fifteen messages: at their end it has nothing to look ahead to, and hardly filters.
# loses: filters
# skips: noise_reduced, delay_bounded, begins_near, restart_noticed, survives_nan
# cause: filters.passes-through
# replaces: from scipy.signal import butter, sosfilt, sosfilt_zi
from scipy.signal import butter, sosfiltfilt, sosfilt_zi

# replaces:     self.memory = AT_REST[:, :, np.newaxis] * angles
    self.memory = np.tile(angles, (15, 1))

# replaces: filtered, self.memory = sosfilt(FILTER, angles[np.newaxis], axis=0, zi=self.memory)
self.memory = np.vstack([self.memory[1:], angles])
filtered = sosfiltfilt(FILTER, self.memory, axis=0)[-1:]
