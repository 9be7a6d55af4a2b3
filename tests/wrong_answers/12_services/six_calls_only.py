# Calls six times, and no more; the last of these calls gets no answer.
# loses: asks_every_second
# cause: asks-every-second.stops-at-a-later-one
# after: self.open_call: Future | None = None
self.sent = 0

# replaces: self.open_call = self.self_test.call_async(Trigger.Request())
self.sent += 1
if self.sent > 6:
    self.open_call = None
    return
self.open_call = self.self_test.call_async(Trigger.Request())
