# Keeps the status in a local variable.
# loses: status_at_once
# skips: status_follows
# cause: status-at-once.not-kept
# says: "unknown"
# replaces: self.last_status = message.data
last_status = message.data
