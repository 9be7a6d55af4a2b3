# Answers are collected, and reported together every three and a half seconds.
# loses: results_told
# cause: results-told.collected
# after: self.open_call: Future | None = None
self.collected: list[str] = []
self.create_timer(3.5, self.report_all)

# replaces: self.report("ok" if future.result().success else "faulty")
self.collected.append("ok" if future.result().success else "faulty")

# before: def report(self, health: str) -> None:
def report_all(self) -> None:
    while self.collected:
        self.report(self.collected.pop(0))

