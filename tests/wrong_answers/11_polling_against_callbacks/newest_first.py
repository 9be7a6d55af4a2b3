# All touches are kept, and the newest is taken first.
# loses: once_in_order, quick
# cause: once-in-order.other-order
# on: starter
# replaces: self.last = 0  # the touch that arrived last
self.touches: list[int] = []

# replaces: self.last = touch.data
self.touches.append(touch.data)

# replaces: if self.last != self.reported:
# replaces:     self.reported = self.last
# replaces:     self.seen_publisher.publish(Int32(data=self.reported))
while self.touches:
    self.seen_publisher.publish(Int32(data=self.touches.pop()))
