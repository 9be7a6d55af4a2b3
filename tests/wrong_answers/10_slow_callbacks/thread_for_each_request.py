# A thread for each request, and one planner for all of them.
# loses: plans_right, all_in_order
# cause: plans-right.race
# on: starter
# after: import math
import threading

# before: def on_request(self, request: Float32) -> None:
def work(self, request: Float32) -> None:
    self.plan_publisher.publish(Float32(data=self.planner.plan(request.data)))

# replaces: bend = self.planner.plan(request.data)
# replaces: self.plan_publisher.publish(Float32(data=bend))
threading.Thread(target=self.work, args=(request,), daemon=True).start()
