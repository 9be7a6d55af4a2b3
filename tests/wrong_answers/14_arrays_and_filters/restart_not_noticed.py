# Knows one start only.
# loses: restart_noticed
# cause: restart-noticed.remembers
# replaces: if self.memory is None or stamp < self.last_stamp:  # the first message, or the first after a restart
if self.memory is None:
