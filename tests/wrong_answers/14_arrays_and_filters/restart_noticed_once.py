# Begins anew after the first restart, and after no other.
# loses: restart_noticed
# cause: restart-noticed.first-only
# after: self.memory: np.ndarray | None = None
self.restarted = False

# replaces: if self.memory is None or stamp < self.last_stamp:  # the first message, or the first after a restart
restarts = stamp < self.last_stamp and not self.restarted
self.restarted = self.restarted or restarts
if self.memory is None or restarts:
