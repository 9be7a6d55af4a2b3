# Drops the first answer after each call without one, as if it belonged to that call.
# loses: results_told
# cause: results-told.none-after-no-answer
# after: self.open_call: Future | None = None
self.one_is_old = False

# replaces: self.report("no answer")
self.report("no answer")
self.one_is_old = True

# replaces: self.report("ok" if future.result().success else "faulty")
if not self.one_is_old:
    self.report("ok" if future.result().success else "faulty")
self.one_is_old = False
