# The program ends after sixty touches. What it has reported last has time to arrive.
# loses: alive_at_end
# cause: alive-at-end.ended
# after: super().__init__("touch_monitor")
self.left = 60

# replaces: self.seen_publisher.publish(Int32(data=touch.data))
self.seen_publisher.publish(Int32(data=touch.data))
self.left -= 1
if self.left == 0:
    self.create_timer(0.3, self.context.shutdown)
