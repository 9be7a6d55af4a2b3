# The last stamp stays that of before the restart, so each message after it looks like a restart.
# loses: noise_reduced
# cause: noise-reduced.not-after-restart
# replaces: self.last_stamp = stamp
self.last_stamp = max(stamp, self.last_stamp)
