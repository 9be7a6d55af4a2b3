# Whoever asks while a plan is being made is ignored.
# loses: all_in_order
# cause: all-in-order.missing
# on: starter
# after: import math
import threading

# after: self.planner = ElbowPlanner()
self.busy = False

# replaces: bend = self.planner.plan(request.data)
# replaces: self.plan_publisher.publish(Float32(data=bend))
if self.busy:
    return
self.busy = True
threading.Thread(target=self.work, args=(request.data,), daemon=True).start()

# before: def on_request(self, request: Float32) -> None:
def work(self, distance: float) -> None:
    self.plan_publisher.publish(Float32(data=self.planner.plan(distance)))
    self.busy = False
