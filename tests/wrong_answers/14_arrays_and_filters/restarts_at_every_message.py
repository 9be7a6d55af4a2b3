# The comparison is the wrong way round: every message looks like a restart.
# loses: noise_reduced, restart_noticed, survives_nan
# cause: noise-reduced.none
# replaces: if self.memory is None or stamp < self.last_stamp:  # the first message, or the first after a restart
if self.memory is None or stamp > self.last_stamp:
