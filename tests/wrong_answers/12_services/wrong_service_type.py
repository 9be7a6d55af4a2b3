# Another type of service.
# loses: calls_arrive
# skips: asks_every_second, results_told, unanswered_told
# cause: calls-service.other-type
# says: SetBool
# replaces: from std_srvs.srv import Trigger
from std_srvs.srv import SetBool

# replaces: self.self_test = self.create_client(Trigger, "/robot/self_test")
self.self_test = self.create_client(SetBool, "/robot/self_test")

# replaces: self.open_call = self.self_test.call_async(Trigger.Request())
self.open_call = self.self_test.call_async(SetBool.Request())
