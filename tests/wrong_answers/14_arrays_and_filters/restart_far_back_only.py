# Takes a stamp for a restart only if it is ten seconds before the last one.
# loses: restart_noticed
# cause: restart-noticed.first-only
# says: 0.56 s
# replaces: if self.memory is None or stamp < self.last_stamp:  # the first message, or the first after a restart
if self.memory is None or stamp[0] < self.last_stamp[0] - 10:
