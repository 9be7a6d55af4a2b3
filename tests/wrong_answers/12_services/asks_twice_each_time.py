# Sends two requests with each tick of the timer, and waits only for the first.
# loses: asks_every_second, results_told, unanswered_told
# cause: asks-every-second.several-at-once
# says: 2 at a time
# after: self.open_call.add_done_callback(self.on_answer)
self.self_test.call_async(Trigger.Request())
