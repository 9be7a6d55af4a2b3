# Beats five times a second.
# loses: heartbeat_kept
# cause: heartbeat-kept.too-few
# replaces: self.create_timer(0.1, self.beat)
self.create_timer(0.2, self.beat)
