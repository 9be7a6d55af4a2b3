# Spins its node in its own callback, and reads the result without a look at whether there is one.
# loses: calls_arrive, alive_at_end
# skips: asks_every_second, results_told, unanswered_told, heartbeat_steady
# cause: alive-at-end.waited-in-vain
# says: 'NoneType' object has no attribute 'success'
# replaces: if self.open_call is not None:
# replaces:     self.self_test.remove_pending_request(self.open_call)
# replaces:     self.report("no answer")
# replaces: self.open_call = self.self_test.call_async(Trigger.Request())
# replaces: self.open_call.add_done_callback(self.on_answer)
future = self.self_test.call_async(Trigger.Request())
rclpy.spin_until_future_complete(self, future, timeout_sec=0.9)
self.report("ok" if future.result().success else "faulty")
