# Asks nothing for three seconds after a call without an answer.
# loses: asks_every_second
# cause: asks-every-second.waits-for-unanswered
# after: self.open_call: Future | None = None
self.rests = 0

# before: if self.open_call is not None:
self.rests -= 1
if self.rests > 0:
    return

# after: self.report("no answer")
self.open_call = None
self.rests = 3
return
