# The worker is started, and what it has found by then is published.
# loses: plans_right, all_in_order
# cause: plans-right.not-yet-found
# on: starter
# after: import math
import threading

# after: self.planner = ElbowPlanner()
self.result = 0.0
self.lock = threading.Lock()

# before: def on_request(self, request: Float32) -> None:
def work(self, distance: float) -> None:
    with self.lock:
        self.result = self.planner.plan(distance)

# replaces: bend = self.planner.plan(request.data)
# replaces: self.plan_publisher.publish(Float32(data=bend))
threading.Thread(target=self.work, args=(request.data,), daemon=True).start()
self.plan_publisher.publish(Float32(data=self.result))
