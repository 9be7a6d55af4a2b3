# The heart begins to beat with the first request.
# loses: heartbeat_gap
# cause: heartbeat-gap.begins-late
# after: self.planner = ElbowPlanner()
self.asked = False

# before: self.heartbeat_publisher.publish(String(data="alive"))
if not self.asked:
    return

# before: bend = self.planner.plan(request.data)
self.asked = True
