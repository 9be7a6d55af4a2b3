# A character is missing in the name of the service.
# loses: calls_arrive
# skips: asks_every_second, results_told, unanswered_told
# cause: calls-service.other-name
# says: /robot/selftest
# replaces: self.self_test = self.create_client(Trigger, "/robot/self_test")
self.self_test = self.create_client(Trigger, "/robot/selftest")
