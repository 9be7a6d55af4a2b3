# The service's class in the place of its request.
# loses: calls_arrive, alive_at_end
# skips: asks_every_second, results_told, unanswered_told, heartbeat_steady
# cause: error.service-itself
# replaces: self.open_call = self.self_test.call_async(Trigger.Request())
self.open_call = self.self_test.call_async(Trigger())
