# Spins the node in its own callback, whose group the answer needs.
# loses: results_told, unanswered_told, heartbeat_steady
# cause: results-told.waits-in-callback
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
