# A touch with the same number as the one before is taken for a copy of it.
# loses: none_missed
# cause: none-missed.number-known
# after: super().__init__("touch_monitor")
self.last = 0

# replaces: self.seen_publisher.publish(Int32(data=touch.data))
if touch.data != self.last:
    self.last = touch.data
    self.seen_publisher.publish(Int32(data=touch.data))
