# One joint goes through another filter, and is far behind.
# loses: delay_bounded
# cause: delay-bounded.one-joint
# says: neck
# after: self.memory: np.ndarray | None = None
self.neck = 0.0

# after: self.memory = AT_REST[:, :, np.newaxis] * angles
self.neck = angles[0]

# after: filtered, self.memory = sosfilt(FILTER, angles[np.newaxis], axis=0, zi=self.memory)
self.neck += 0.12 * (filtered[0, 0] - self.neck)
filtered[0, 0] = self.neck
