# Asks only for what is said from now on.
# loses: status_at_once
# skips: status_follows
# cause: status-at-once.volatile
# replaces: self.create_subscription(String, "/robot/status", self.on_status, STATE_QOS)
self.create_subscription(String, "/robot/status", self.on_status, 10)
