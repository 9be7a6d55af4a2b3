# Of several calls in a row without an answer, only the first is reported.
# loses: unanswered_told
# cause: unanswered-told.once-in-a-row
# after: self.open_call: Future | None = None
self.is_silent = False

# replaces: self.report("no answer")
if not self.is_silent:
    self.report("no answer")
self.is_silent = True

# replaces: self.report("ok" if future.result().success else "faulty")
self.is_silent = False
self.report("ok" if future.result().success else "faulty")
