# Awaits an answer that may never come.
# loses: asks_every_second, unanswered_told
# cause: asks-every-second.waits-for-unanswered
# after: import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup

# replaces: self.create_timer(ASK_PERIOD_S, self.ask)
self.create_timer(ASK_PERIOD_S, self.ask, callback_group=MutuallyExclusiveCallbackGroup())

# replaces: def ask(self) -> None:
async def ask(self) -> None:

# replaces: if self.open_call is not None:
# replaces:     self.self_test.remove_pending_request(self.open_call)
# replaces:     self.report("no answer")
# replaces: self.open_call = self.self_test.call_async(Trigger.Request())
# replaces: self.open_call.add_done_callback(self.on_answer)
response = await self.self_test.call_async(Trigger.Request())
self.report("ok" if response.success else "faulty")
