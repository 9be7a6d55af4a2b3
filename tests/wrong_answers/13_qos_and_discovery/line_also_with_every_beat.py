# Publishes the line from its timer, and once more with every beat.
# loses: line_rate
# cause: line-rate.also-with-each-beat
# after: self.last_beat = time.monotonic()
self.publish_line()
