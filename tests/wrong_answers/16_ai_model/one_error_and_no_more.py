# Publishes the status until the fall, says error once, and then no more.
# loses: heartbeat_kept
# cause: heartbeat-kept.ends-with-the-fall
# after: super().__init__("desk_watcher")
self.said = False
# replaces: self.status_publisher.publish(String(data="error" if self.fallen else "operational"))
if not self.said:
    self.status_publisher.publish(String(data="error" if self.fallen else "operational"))
self.said = self.fallen
