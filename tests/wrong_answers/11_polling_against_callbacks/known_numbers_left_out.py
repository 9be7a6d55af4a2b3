# A number that was reported once is not reported again.
# loses: none_missed
# cause: none-missed.number-known
# after: super().__init__("touch_monitor")
self.known: set[int] = set()

# replaces: self.seen_publisher.publish(Int32(data=touch.data))
if touch.data not in self.known:
    self.known.add(touch.data)
    self.seen_publisher.publish(Int32(data=touch.data))
