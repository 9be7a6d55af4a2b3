# Never gives up an open call, and never asks again.
# loses: asks_every_second, unanswered_told
# cause: asks-every-second.waits-for-unanswered
# replaces: self.self_test.remove_pending_request(self.open_call)
# replaces: self.report("no answer")
self.report("no answer")
return
