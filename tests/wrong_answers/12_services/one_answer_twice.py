# Reports the first answer twice.
# loses: results_told
# cause: results-told.one-twice
# after: self.open_call: Future | None = None
self.first = True

# after: self.report("ok" if future.result().success else "faulty")
if self.first:
    self.report("ok" if future.result().success else "faulty")
self.first = False
