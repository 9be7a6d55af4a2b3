# The text is never filled in.
# loses: heartbeat_topic
# skips: heartbeat_count
# cause: has-text.empty
# says: /robot/heartbeat
# replaces: self.heartbeat_publisher.publish(String(data="alive"))
self.heartbeat_publisher.publish(String())
