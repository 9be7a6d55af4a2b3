# A letter too many in the name of the topic.
# loses: line_topic
# skips: line_rate, status_at_once, status_follows
# cause: publishes.other-name
# says: /dashboard/lines
# replaces: self.line_publisher = self.create_publisher(String, "/dashboard/line", 10)
self.line_publisher = self.create_publisher(String, "/dashboard/lines", 10)
