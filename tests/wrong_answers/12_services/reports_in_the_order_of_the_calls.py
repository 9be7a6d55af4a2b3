# Keeps an answer back until all earlier calls are settled.
# on: right/several_calls_open.py
# loses: results_told
# cause: results-told.waits-for-earlier-call
# replaces: PATIENCE = Duration(seconds=1.5)
PATIENCE = Duration(seconds=1.95)

# replaces: if self.open.pop(future, None) is not None:
# replaces:     self.say("ok" if future.result().success else "faulty")
while self.open and next(iter(self.open)).done():
    oldest = next(iter(self.open))
    del self.open[oldest]
    self.say("ok" if oldest.result().success else "faulty")

# replaces: for future in [one for one, until in self.open.items() if until < now]:
for future in [one for one, until in self.open.items() if until < now and not one.done()]:

# after: self.say("no answer")
self.done(future)
