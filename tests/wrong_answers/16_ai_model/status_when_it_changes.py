# Publishes the status when it changes, and not otherwise.
# loses: heartbeat_kept
# cause: heartbeat-kept.rarely
# after: self.fallen = False
self.word = ""
# replaces: self.status_publisher.publish(String(data="error" if self.fallen else "operational"))
word = "error" if self.fallen else "operational"
if word != self.word:
    self.word = word
    self.status_publisher.publish(String(data=word))
