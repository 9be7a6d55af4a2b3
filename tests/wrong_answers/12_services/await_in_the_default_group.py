# Timer and client share the default group, so the answer waits for the one who waits for it.
# loses: calls_arrive, heartbeat_steady
# skips: asks_every_second, results_told, unanswered_told
# cause: calls-arrive.deadlock
# replaces: def ask(self) -> None:
async def ask(self) -> None:

# replaces: if self.open_call is not None:
# replaces:     self.self_test.remove_pending_request(self.open_call)
# replaces:     self.report("no answer")
# replaces: self.open_call = self.self_test.call_async(Trigger.Request())
# replaces: self.open_call.add_done_callback(self.on_answer)
response = await self.self_test.call_async(Trigger.Request())
self.report("ok" if response.success else "faulty")
