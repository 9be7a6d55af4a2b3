# Takes the result of the call that it gives up: there is none.
# loses: alive_at_end
# skips: asks_every_second, unanswered_told, heartbeat_steady
# cause: alive-at-end.result-of-none
# says: 'NoneType' object has no attribute 'success'
# replaces: self.report("no answer")
self.on_answer(self.open_call)
