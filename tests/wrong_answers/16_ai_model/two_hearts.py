# Beats twenty times a second.
# loses: heartbeat_kept
# cause: heartbeat-kept.too-many
# replaces: self.create_timer(0.1, self.beat)
self.create_timer(0.05, self.beat)
