# Looks at the answer a second later, when it asks again.
# loses: results_told
# cause: results-told.late
# replaces: self.self_test.remove_pending_request(self.open_call)
# replaces: self.report("no answer")
if self.open_call.done():
    self.report("ok" if self.open_call.result().success else "faulty")
else:
    self.self_test.remove_pending_request(self.open_call)
    self.report("no answer")

# replaces: self.open_call.add_done_callback(self.on_answer)
