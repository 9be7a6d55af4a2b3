# The first touch is taken for a test.
# loses: none_missed
# cause: none-missed.the-first
# after: super().__init__("touch_monitor")
self.tested = False

# replaces: self.seen_publisher.publish(Int32(data=touch.data))
if self.tested:
    self.seen_publisher.publish(Int32(data=touch.data))
self.tested = True
