# Takes the future for the response.
# loses: calls_arrive, alive_at_end
# skips: asks_every_second, results_told, unanswered_told, heartbeat_steady
# cause: error.result-not-taken
# says: future.result().success
# replaces: self.report("ok" if future.result().success else "faulty")
self.report("ok" if future.success else "faulty")
