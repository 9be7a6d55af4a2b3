# Of the requests that wait, the nearest distance is taken first.
# loses: all_in_order
# cause: all-in-order.other-order
# on: starter
# after: import math
import queue
import threading

# after: self.plan_publisher = self.create_publisher(Float32, "/robot/plan", 10)
self.requests: queue.PriorityQueue[float] = queue.PriorityQueue()
threading.Thread(target=self.work, daemon=True).start()

# replaces: bend = self.planner.plan(request.data)
# replaces: self.plan_publisher.publish(Float32(data=bend))
self.requests.put(request.data)

# before: def on_request(self, request: Float32) -> None:
def work(self) -> None:
    while True:
        self.plan_publisher.publish(Float32(data=self.planner.plan(self.requests.get())))

