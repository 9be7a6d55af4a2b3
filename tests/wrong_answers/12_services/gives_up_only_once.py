# Gives up the first call without an answer, and no other.
# loses: unanswered_told
# cause: unanswered-told.first-only
# after: self.open_call: Future | None = None
self.gave_up = False

# replaces: self.report("no answer")
if not self.gave_up:
    self.report("no answer")
self.gave_up = True
