# Takes it for a restart when a joint has jumped by more than 0.3 rad. Once the joints were turned less than that.
# loses: restart_noticed
# cause: restart-noticed.first-only
# replaces: if self.memory is None or stamp < self.last_stamp:  # the first message, or the first after a restart
if self.memory is None or np.nanmax(np.abs(angles - self.last_good), initial=0.0) > 0.3:
