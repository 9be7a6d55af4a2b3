# Says once, by a timer, that all is well.
# loses: results_told
# cause: results-told.without-an-answer
# replaces: self.create_timer(ASK_PERIOD_S, self.ask)
self.create_timer(ASK_PERIOD_S, self.ask)
self.greeting = self.create_timer(4.5, self.greet)

# before: def ask(self) -> None:
def greet(self) -> None:
    """Say that all is well."""
    self.greeting.cancel()
    self.report("ok")

