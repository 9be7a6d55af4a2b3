# After the answer "faulty" it calls again at once, to confirm it.
# loses: asks_every_second, unanswered_told
# cause: asks-every-second.asks-after-an-answer
# replaces: self.report("ok" if future.result().success else "faulty")
self.report("ok" if future.result().success else "faulty")
if not future.result().success:
    self.ask()
