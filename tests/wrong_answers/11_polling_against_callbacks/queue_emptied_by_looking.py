# All touches are kept, and reported five times a second.
# loses: quick
# cause: quick.polls
# on: starter
# replaces: self.last = 0  # the touch that arrived last
self.touches: list[int] = []

# replaces: self.last = touch.data
self.touches.append(touch.data)

# replaces: if self.last != self.reported:
# replaces:     self.reported = self.last
# replaces:     self.seen_publisher.publish(Int32(data=self.reported))
while self.touches:
    self.seen_publisher.publish(Int32(data=self.touches.pop(0)))
