# Does not report the first answer.
# loses: results_told
# cause: results-told.one-left-out
# after: self.open_call: Future | None = None
self.warm = False

# replaces: self.report("ok" if future.result().success else "faulty")
if self.warm:
    self.report("ok" if future.result().success else "faulty")
self.warm = True
