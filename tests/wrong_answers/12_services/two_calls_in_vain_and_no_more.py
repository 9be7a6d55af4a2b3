# After the second call without an answer, it calls no more.
# loses: asks_every_second
# cause: asks-every-second.stops-at-a-later-one
# after: self.open_call: Future | None = None
self.in_vain = 0

# replaces: self.report("no answer")
self.report("no answer")
self.in_vain += 1

# replaces: self.open_call = self.self_test.call_async(Trigger.Request())
if self.in_vain > 1:
    self.open_call = None
    return
self.open_call = self.self_test.call_async(Trigger.Request())
