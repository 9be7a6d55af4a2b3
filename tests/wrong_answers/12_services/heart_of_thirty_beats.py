# The heart beats thirty times.
# loses: heartbeat_steady
# cause: heartbeat-steady.stops-alone
# after: self.open_call: Future | None = None
self.beats = 0

# before: self.heartbeat_publisher.publish(String(data="alive"))
self.beats += 1
if self.beats > 30:
    return
