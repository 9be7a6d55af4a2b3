# Says nothing when there is no answer.
# loses: unanswered_told
# cause: unanswered-told.never
# replaces: if self.open_call is not None:
# replaces:     self.self_test.remove_pending_request(self.open_call)
# replaces:     self.report("no answer")
# replaces: self.open_call = self.self_test.call_async(Trigger.Request())
# replaces: self.open_call.add_done_callback(self.on_answer)
self.self_test.call_async(Trigger.Request()).add_done_callback(self.on_answer)

# replaces: if future is not self.open_call:
# replaces:     return
# replaces: self.open_call = None
