# The comparison is the wrong way round: every message looks like a restart.
# loses: filters
# skips: noise_reduced, delay_bounded, begins_near, restart_noticed, survives_nan
# cause: filters.passes-through
# replaces: if self.memory is None or stamp < self.last_stamp:  # the first message, or the first after a restart
if self.memory is None or stamp > self.last_stamp:
