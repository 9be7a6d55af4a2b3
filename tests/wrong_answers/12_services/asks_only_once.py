# Asks when the service is there, and never again.
# loses: calls_arrive
# skips: asks_every_second, results_told, unanswered_told
# cause: calls-arrive.asks-no-more
# replaces: self.create_timer(ASK_PERIOD_S, self.ask)
self.self_test.wait_for_service()
self.ask()
