# The heartbeat has a group of its own, but timer and client share one: the answer waits for the one who waits
# for it.
# loses: calls_arrive
# skips: asks_every_second, results_told, unanswered_told
# cause: calls-arrive.asks-no-more
# after: import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup

# replaces: self.create_timer(HEARTBEAT_PERIOD_S, self.beat)
self.create_timer(HEARTBEAT_PERIOD_S, self.beat, callback_group=MutuallyExclusiveCallbackGroup())

# replaces: def ask(self) -> None:
async def ask(self) -> None:

# replaces: if self.open_call is not None:
# replaces:     self.self_test.remove_pending_request(self.open_call)
# replaces:     self.report("no answer")
# replaces: self.open_call = self.self_test.call_async(Trigger.Request())
# replaces: self.open_call.add_done_callback(self.on_answer)
response = await self.self_test.call_async(Trigger.Request())
self.report("ok" if response.success else "faulty")
