# Several calls may be open; the answer to one of them makes it forget all of them.
# loses: unanswered_told
# cause: unanswered-told.forgotten
# replaces: self.open_call: Future | None = None
self.open_calls: dict[Future, int] = {}
self.ticks = 0
self.create_timer(0.1, self.look)

# replaces: if self.open_call is not None:
# replaces:     self.self_test.remove_pending_request(self.open_call)
# replaces:     self.report("no answer")
# replaces: self.open_call = self.self_test.call_async(Trigger.Request())
# replaces: self.open_call.add_done_callback(self.on_answer)
future = self.self_test.call_async(Trigger.Request())
self.open_calls[future] = self.ticks
future.add_done_callback(self.on_answer)

# before: def on_answer(self, future: Future) -> None:
def look(self) -> None:
    """Give up what has waited for too long."""
    self.ticks += 1
    for future in [one for one, since in self.open_calls.items() if self.ticks - since > 13]:
        del self.open_calls[future]
        self.self_test.remove_pending_request(future)
        self.report("no answer")

# replaces: if future is not self.open_call:
# replaces:     return
# replaces: self.open_call = None
if future not in self.open_calls:
    return
self.open_calls.clear()
