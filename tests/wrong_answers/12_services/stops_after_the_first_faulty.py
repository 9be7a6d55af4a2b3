# Sends no more requests after the first bad result.
# loses: calls_arrive
# skips: asks_every_second, results_told, unanswered_told
# cause: calls-arrive.stops
# replaces: self.create_timer(ASK_PERIOD_S, self.ask)
self.asking = self.create_timer(ASK_PERIOD_S, self.ask)

# replaces: self.report("ok" if future.result().success else "faulty")
self.report("ok" if future.result().success else "faulty")
if not future.result().success:
    self.asking.cancel()
