# Adds a word to the line.
# loses: status_follows
# cause: status-follows.two-words
# replaces: self.line_publisher.publish(String(data=self.last_status))
self.line_publisher.publish(String(data=f"{self.last_status}, errors: 0"))
