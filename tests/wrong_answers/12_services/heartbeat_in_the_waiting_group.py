# The client has a group of its own, but the heartbeat shares one with the timer that waits.
# loses: heartbeat_steady
# cause: heartbeat-steady.stops-during-a-call
# after: import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup

# replaces: from rclpy.executors import ExternalShutdownException
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor

# replaces: self.self_test = self.create_client(Trigger, "/robot/self_test")
self.self_test = self.create_client(
    Trigger, "/robot/self_test", callback_group=MutuallyExclusiveCallbackGroup()
)

# replaces: if self.open_call is not None:
# replaces:     self.self_test.remove_pending_request(self.open_call)
# replaces:     self.report("no answer")
# replaces: self.open_call = self.self_test.call_async(Trigger.Request())
# replaces: self.open_call.add_done_callback(self.on_answer)
response = self.self_test.call(Trigger.Request(), timeout_sec=0.9)
if response is None:
    self.report("no answer")
else:
    self.report("ok" if response.success else "faulty")

# replaces: rclpy.spin(HealthMonitor())
executor = MultiThreadedExecutor()
executor.add_node(HealthMonitor())
executor.spin()
