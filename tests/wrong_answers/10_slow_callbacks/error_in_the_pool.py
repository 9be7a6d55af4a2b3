# The work goes to a pool; a slip in it is never seen.
# loses: plans_right, all_in_order
# cause: plans-right.none
# on: starter
# after: import time
from concurrent.futures import ThreadPoolExecutor

# after: self.planner = ElbowPlanner()
self.pool = ThreadPoolExecutor(max_workers=1)

# replaces: bend = self.planner.plan(request.data)
# replaces: self.plan_publisher.publish(Float32(data=bend))
self.pool.submit(self.work, request)

# before: def on_request(self, request: Float32) -> None:
def work(self, request: Float32) -> None:
    self.plan_publisher.publish(Float32(self.planner.plan(request.data)))
