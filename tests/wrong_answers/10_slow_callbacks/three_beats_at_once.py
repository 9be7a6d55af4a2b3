# Three heartbeats every 0.3 s.
# loses: heartbeat_share
# cause: heartbeat-share.in-groups
# replaces: self.create_timer(HEARTBEAT_PERIOD_S, self.beat)
self.create_timer(3 * HEARTBEAT_PERIOD_S, self.beat)

# after: self.heartbeat_publisher.publish(String(data="alive"))
self.heartbeat_publisher.publish(String(data="alive"))
self.heartbeat_publisher.publish(String(data="alive"))
