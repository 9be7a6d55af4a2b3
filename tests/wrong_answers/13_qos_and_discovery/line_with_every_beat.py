# Publishes the line when the heart beats, so it stops with the heart.
# loses: line_rate
# cause: line-rate.stops-with-the-heart
# replaces: self.create_timer(LINE_PERIOD_S, self.publish_line)

# after: self.last_beat = time.monotonic()
self.publish_line()
