# Takes a slow answer for a good one.
# loses: results_told
# cause: results-told.other-result
# before: import rclpy
import time

# after: self.open_call = self.self_test.call_async(Trigger.Request())
self.asked_at = time.monotonic()

# replaces: self.report("ok" if future.result().success else "faulty")
slow = time.monotonic() - self.asked_at > 0.5
self.report("ok" if slow or future.result().success else "faulty")
