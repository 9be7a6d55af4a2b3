# A heartbeat at each step of the planner, since the timer cannot.
# loses: heartbeat_share
# cause: heartbeat-share.too-many
# on: starter
# replaces: bend = self.planner.plan(request.data)
# replaces: self.plan_publisher.publish(Float32(data=bend))
self.planner.begin(request.data)
for _ in range(self.planner.STEPS):
    self.planner.step()
    self.beat()
self.plan_publisher.publish(Float32(data=self.planner.bend()))
