# Notes the restart, and fills the memory with the message after that.
# loses: restart_noticed
# cause: restart-noticed.one-late
# after: self.memory: np.ndarray | None = None
self.due = False

# replaces: if self.memory is None or stamp < self.last_stamp:  # the first message, or the first after a restart
due, self.due = self.due, stamp < self.last_stamp
if self.memory is None or due:
