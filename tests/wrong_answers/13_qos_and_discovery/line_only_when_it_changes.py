# Publishes the line when a status comes, and not twice a second.
# loses: line_rate, status_at_once
# skips: status_follows
# cause: line-rate.only-with-a-status
# replaces: self.create_timer(LINE_PERIOD_S, self.publish_line)

# after: self.last_status = message.data
self.publish_line()
