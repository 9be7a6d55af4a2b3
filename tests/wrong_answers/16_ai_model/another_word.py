# Says "ok" for "operational".
# loses: heartbeat_kept
# cause: one-of.other-text
# replaces: self.status_publisher.publish(String(data="error" if self.fallen else "operational"))
self.status_publisher.publish(String(data="error" if self.fallen else "ok"))
