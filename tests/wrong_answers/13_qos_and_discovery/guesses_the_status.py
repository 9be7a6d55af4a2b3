# Begins with a word that it cannot know, and asks only for what is said from now on.
# loses: status_at_once
# skips: status_follows
# cause: status-at-once.guessed
# says: "error"
# replaces: self.last_status = "unknown"
self.last_status = "error"

# replaces: self.create_subscription(String, "/robot/status", self.on_status, STATE_QOS)
self.create_subscription(String, "/robot/status", self.on_status, 10)
