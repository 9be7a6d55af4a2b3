# Reports a result only when it differs from the last one.
# loses: results_told, unanswered_told
# cause: results-told.changes-only
# after: self.open_call: Future | None = None
self.last_health = ""

# before: self.health_publisher.publish(String(data=health))
if health == self.last_health:
    return
self.last_health = health
