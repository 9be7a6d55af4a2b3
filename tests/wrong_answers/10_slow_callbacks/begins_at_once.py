# The search is begun when the request comes, and its steps follow in a thread.
# loses: plans_right, all_in_order
# cause: plans-right.overwritten
# on: starter
# after: import time
import queue
import threading

# after: self.planner = ElbowPlanner()
self.requests: queue.Queue[float] = queue.Queue()
threading.Thread(target=self.work, daemon=True).start()

# replaces: bend = self.planner.plan(request.data)
# replaces: self.plan_publisher.publish(Float32(data=bend))
self.planner.begin(request.data)
self.requests.put(request.data)

# before: def on_request(self, request: Float32) -> None:
def work(self) -> None:
    while True:
        distance = self.requests.get()
        for _ in range(self.planner.STEPS):
            self.planner.step()
        self.plan_publisher.publish(Float32(data=self.planner.bend()))
