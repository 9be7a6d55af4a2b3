# While the heart is silent, the line says that no status is known.
# loses: status_follows
# cause: status-follows.unknown-again
# says: "unknown"
# replaces: self.line_publisher.publish(String(data=self.last_status))
self.line_publisher.publish(String(data="unknown" if self.alarm else self.last_status))
