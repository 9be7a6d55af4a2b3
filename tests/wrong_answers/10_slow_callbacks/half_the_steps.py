# Cut into steps, and some of them forgotten.
# loses: plans_right
# cause: plans-right.planner-left-out
# on: starter
# after: import time
from collections import deque

# after: self.planner = ElbowPlanner()
self.waiting: deque[float] = deque()
self.steps = 0
self.create_timer(0.05, self.go_on)

# before: def on_request(self, request: Float32) -> None:
def go_on(self) -> None:
    if self.steps == 0 and self.waiting:
        self.planner.begin(self.waiting.popleft())
        self.steps = 8
    if self.steps:
        self.planner.step()
        self.steps -= 1
        if self.steps == 0:
            self.plan_publisher.publish(Float32(data=self.planner.bend()))

# replaces: bend = self.planner.plan(request.data)
# replaces: self.plan_publisher.publish(Float32(data=bend))
self.waiting.append(request.data)
