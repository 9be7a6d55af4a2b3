# A touch that comes after a skipped number is logged as an error, and not reported.
# loses: none_missed
# cause: none-missed.after-a-gap
# after: super().__init__("touch_monitor")
self.last = 0

# replaces: self.seen_publisher.publish(Int32(data=touch.data))
expected, self.last = self.last + 1, touch.data
if 1 < expected < touch.data:
    self.get_logger().error(f"touch {expected} is missing")
else:
    self.seen_publisher.publish(Int32(data=touch.data))
