# The heart begins to beat when the first plan is made.
# loses: heartbeat_share, heartbeat_gap
# cause: heartbeat-share.begins-late
# replaces: self.create_timer(HEARTBEAT_PERIOD_S, self.beat)
self.heart = None

# after: self.plan_publisher.publish(Float32(data=bend))
if self.heart is None:
    self.heart = self.create_timer(HEARTBEAT_PERIOD_S, self.beat)
