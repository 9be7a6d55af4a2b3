# The heart beats fifty times.
# loses: heartbeat_share, heartbeat_gap
# cause: heartbeat-share.stops
# after: self.planner = ElbowPlanner()
self.left = 50

# replaces: self.heartbeat_publisher.publish(String(data="alive"))
if self.left > 0:
    self.left -= 1
    self.heartbeat_publisher.publish(String(data="alive"))
