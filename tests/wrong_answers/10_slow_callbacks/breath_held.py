# The timer of the heartbeat waits for something else, once.
# loses: heartbeat_gap
# cause: heartbeat-gap.held-up
# after: self.planner = ElbowPlanner()
self.beats = 0

# replaces: self.heartbeat_publisher.publish(String(data="alive"))
self.beats += 1
if self.beats == 76:
    time.sleep(0.75)
self.heartbeat_publisher.publish(String(data="alive"))
