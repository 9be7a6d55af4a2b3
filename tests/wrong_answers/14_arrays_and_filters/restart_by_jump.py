# Takes a jump for a restart: a joint that was turned only a little begins where it was before.
# loses: restart_noticed
# cause: restart-noticed.some-joints
# says: right_elbow
# replaces: if self.memory is None or stamp < self.last_stamp:  # the first message, or the first after a restart
if self.memory is None:

# after: angles = np.where(np.isfinite(angles), angles, self.last_good)
jumped = np.abs(angles - self.last_good) > 0.35
self.memory[:, :, jumped] = (AT_REST[:, :, np.newaxis] * angles)[:, :, jumped]
