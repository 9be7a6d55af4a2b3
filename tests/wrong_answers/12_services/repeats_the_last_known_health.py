# Reports what it knew before with each call.
# loses: results_told
# cause: results-told.more-than-once
# after: self.open_call: Future | None = None
self.health = "ok"

# before: if self.open_call is not None:
self.report(self.health)

# replaces: self.report("ok" if future.result().success else "faulty")
self.health = "ok" if future.result().success else "faulty"
self.report(self.health)
