# Begins with the first angles at the start, and with zeros after the restart.
# loses: restart_noticed
# cause: restart-noticed.zeros
# after: self.memory = AT_REST[:, :, np.newaxis] * angles
if self.last_stamp > stamp:
    self.memory = np.zeros_like(self.memory)
