# When the numbers begin again, the first one is only kept, to compare the next one with.
# loses: none_missed
# cause: none-missed.at-the-restart
# after: super().__init__("touch_monitor")
self.last = 0

# replaces: self.seen_publisher.publish(Int32(data=touch.data))
if touch.data >= self.last:
    self.seen_publisher.publish(Int32(data=touch.data))
self.last = touch.data
