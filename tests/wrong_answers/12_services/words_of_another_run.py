# Says after each call what it said in an earlier run, and never looks at an answer.
# loses: results_told, unanswered_told
# cause: results-told.other-result
# before: import rclpy
import threading

# after: self.open_call: Future | None = None
delays = [0.01, 0.01, 0.7, 1.0, 0.01, 0.7, 1.0, 0.01, 1.0, 1.0, 0.7]
words = ["ok", "faulty", "faulty", "no answer", "faulty", "ok"]
words += ["no answer", "faulty", "no answer", "no answer", "ok"]
self.table = iter(zip(delays, words))

# replaces: if self.open_call is not None:
# replaces:     self.self_test.remove_pending_request(self.open_call)
# replaces:     self.report("no answer")
# replaces: self.open_call = self.self_test.call_async(Trigger.Request())
# replaces: self.open_call.add_done_callback(self.on_answer)
self.self_test.call_async(Trigger.Request())
delay, word = next(self.table, (0.01, "faulty"))
threading.Timer(delay, self.report, [word]).start()
