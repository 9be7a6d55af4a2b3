# A touch is reported when the next one comes.
# loses: none_missed, quick
# cause: none-missed.the-last
# after: super().__init__("touch_monitor")
self.waiting = 0

# replaces: self.seen_publisher.publish(Int32(data=touch.data))
if self.waiting:
    self.seen_publisher.publish(Int32(data=self.waiting))
self.waiting = touch.data
