# Gives up after 0.4 s.
# loses: results_told, unanswered_told
# cause: results-told.given-up-early
# after: self.create_timer(ASK_PERIOD_S, self.ask)
self.patience = self.create_timer(0.4, self.give_up, autostart=False)

# replaces: if self.open_call is not None:
# replaces:     self.self_test.remove_pending_request(self.open_call)
# replaces:     self.report("no answer")

# after: self.open_call.add_done_callback(self.on_answer)
self.patience.reset()

# before: def on_answer(self, future: Future) -> None:
def give_up(self) -> None:
    self.patience.cancel()
    if self.open_call is not None:
        self.self_test.remove_pending_request(self.open_call)
        self.open_call = None
        self.report("no answer")

# before: self.open_call = None
self.patience.cancel()
