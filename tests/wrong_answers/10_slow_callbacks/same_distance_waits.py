# A distance that is waiting already is not taken again.
# loses: all_in_order
# cause: all-in-order.last-missing
# on: starter
# after: import time
import queue
import threading

# after: self.planner = ElbowPlanner()
self.requests: queue.Queue[float] = queue.Queue()
threading.Thread(target=self.work, daemon=True).start()

# replaces: bend = self.planner.plan(request.data)
# replaces: self.plan_publisher.publish(Float32(data=bend))
if request.data not in self.requests.queue:
    self.requests.put(request.data)

# before: def on_request(self, request: Float32) -> None:
def work(self) -> None:
    while True:
        distance = self.requests.get()
        self.plan_publisher.publish(Float32(data=self.planner.plan(distance)))
