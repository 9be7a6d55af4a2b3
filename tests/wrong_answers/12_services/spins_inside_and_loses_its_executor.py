# Spins the node in its own callback: afterwards it belongs to no executor.
# loses: calls_arrive, heartbeat_steady
# skips: asks_every_second, results_told, unanswered_told
# cause: calls-arrive.lost-its-executor
# after: import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup

# replaces: from rclpy.executors import ExternalShutdownException
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor

# replaces: self.self_test = self.create_client(Trigger, "/robot/self_test")
self.self_test = self.create_client(
    Trigger, "/robot/self_test", callback_group=MutuallyExclusiveCallbackGroup()
)

# replaces: if self.open_call is not None:
# replaces:     self.self_test.remove_pending_request(self.open_call)
# replaces:     self.report("no answer")
# replaces: self.open_call = self.self_test.call_async(Trigger.Request())
# replaces: self.open_call.add_done_callback(self.on_answer)
future = self.self_test.call_async(Trigger.Request())
rclpy.spin_until_future_complete(self, future, timeout_sec=0.9)
response = future.result()
if response is None:
    self.report("no answer")
else:
    self.report("ok" if response.success else "faulty")

# replaces: rclpy.spin(HealthMonitor())
executor = SingleThreadedExecutor()
executor.add_node(HealthMonitor())
executor.spin()
