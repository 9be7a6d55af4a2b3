# Two of three beats are left out while a plan is made.
# loses: heartbeat_share
# cause: heartbeat-share.slower-while-planning
# after: self.planner = ElbowPlanner()
self.busy = False
self.beats = 0

# replaces: self.heartbeat_publisher.publish(String(data="alive"))
self.beats += 1
if not self.busy or self.beats % 3 == 0:
    self.heartbeat_publisher.publish(String(data="alive"))

# replaces: bend = self.planner.plan(request.data)
self.busy = True
bend = self.planner.plan(request.data)
self.busy = False
