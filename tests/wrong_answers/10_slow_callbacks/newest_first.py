# A list as a stack: the newest request is taken first.
# loses: all_in_order
# cause: all-in-order.other-order
# on: starter
# after: import math
import threading

# after: self.planner = ElbowPlanner()
self.requests: list[float] = []

# replaces: self.create_timer(HEARTBEAT_PERIOD_S, self.beat)
self.create_timer(HEARTBEAT_PERIOD_S, self.beat)
threading.Thread(target=self.work, daemon=True).start()

# before: def on_request(self, request: Float32) -> None:
def work(self) -> None:
    while rclpy.ok():
        if self.requests:
            distance = self.requests.pop()
            self.plan_publisher.publish(Float32(data=self.planner.plan(distance)))
        time.sleep(0.01)

# replaces: bend = self.planner.plan(request.data)
# replaces: self.plan_publisher.publish(Float32(data=bend))
self.requests.append(request.data)
