# Between the steps of a search, the heart beats where 0.1 s have passed since it did: every 0.12 s.
# loses: heartbeat_share
# cause: heartbeat-share.slower-while-planning
# on: starter
# replaces: self.heartbeat_publisher.publish(String(data="alive"))
self.beaten = time.monotonic()
self.heartbeat_publisher.publish(String(data="alive"))

# replaces: bend = self.planner.plan(request.data)
self.planner.begin(request.data)
for _ in range(self.planner.STEPS):
    self.planner.step()
    if time.monotonic() - self.beaten >= 0.1:
        self.beat()
bend = self.planner.bend()
