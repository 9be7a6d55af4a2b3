# Compares the nanosec of the stamps alone: begins anew each second, and misses the restart.
# loses: noise_reduced, restart_noticed
# cause: noise-reduced.begins-anew
# replaces: if self.memory is None or stamp < self.last_stamp:  # the first message, or the first after a restart
if self.memory is None or stamp[1] < self.last_stamp[1]:
