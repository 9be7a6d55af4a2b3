# A number that is smaller than the one before is not reported.
# loses: none_missed
# cause: none-missed.smaller-numbers
# after: super().__init__("touch_monitor")
self.greatest = 0

# replaces: self.seen_publisher.publish(Int32(data=touch.data))
if touch.data > self.greatest:
    self.greatest = touch.data
    self.seen_publisher.publish(Int32(data=touch.data))
