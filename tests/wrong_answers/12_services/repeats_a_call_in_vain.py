# After a call without an answer, it calls again at once, and then goes on every second.
# loses: asks_every_second, results_told, unanswered_told
# cause: asks-every-second.calls-between
# replaces: self.create_timer(ASK_PERIOD_S, self.ask)
self.create_timer(ASK_PERIOD_S, self.ask)
self.patience = self.create_timer(0.9, self.give_up, autostart=False)

# replaces: if self.open_call is not None:
# replaces:     self.self_test.remove_pending_request(self.open_call)
# replaces:     self.report("no answer")
if self.open_call is not None:
    self.give_up()

# after: self.open_call.add_done_callback(self.on_answer)
self.patience.reset()

# before: def on_answer(self, future: Future) -> None:
def give_up(self) -> None:
    """Say that there is no answer, and call again at once."""
    self.patience.cancel()
    if self.open_call is not None:
        self.self_test.remove_pending_request(self.open_call)
        self.report("no answer")
        self.open_call = None
        self.ask()
