# Compares the nanosec of the stamps alone: begins anew each second, and misses the restart.
# loses: restart_noticed
# cause: restart-noticed.nanosec-alone
# replaces: if self.memory is None or stamp < self.last_stamp:  # the first message, or the first after a restart
if self.memory is None or stamp[1] < self.last_stamp[1]:
