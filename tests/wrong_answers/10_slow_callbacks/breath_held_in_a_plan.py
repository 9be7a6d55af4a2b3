# The timer of the heartbeat waits for something else, once, while a plan is made.
# loses: heartbeat_gap
# cause: heartbeat-gap.other-plans-do-not
# after: self.planner = ElbowPlanner()
self.beats = 0

# replaces: self.heartbeat_publisher.publish(String(data="alive"))
self.beats += 1
if self.beats == 50:
    time.sleep(0.53)
self.heartbeat_publisher.publish(String(data="alive"))
